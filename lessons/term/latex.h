// Terms as LaTeX, in plain commands that every installation knows.
#pragma once

#include "lessons/term/chain.h"
#include "lessons/term/fractions.h"

#include <string>

namespace halfspace {

/// Whether terms that are marks of the figure say so by `\mark{id}{…}`, which only this program knows.
enum class LatexMarks : std::uint8_t { Without, With };

[[nodiscard]] std::string latexOf(const Term &term, LatexMarks marks = LatexMarks::Without,
                                  Fractions fractions = Fractions::Stacked);
[[nodiscard]] std::string latexOf(const Chain &chain, LatexMarks marks = LatexMarks::Without,
                                  Fractions fractions = Fractions::Stacked);
/// The sides from `begin` on, each but the chain's first with the relation before it.
[[nodiscard]] std::string latexOf(const Chain &chain, std::size_t begin, std::size_t end,
                                  LatexMarks marks = LatexMarks::Without,
                                  Fractions fractions = Fractions::Stacked);
[[nodiscard]] std::string latexOf(const Symbol &symbol);

/// A decimal with the language's mark: 3.14, or 3{,}14, as behind a comma LaTeX leaves a gap else.
[[nodiscard]] std::string latexDecimal(const std::string &decimal);

/// The value behind the relation that it allows: ` = 10`, ` \approx 3.16228`.
[[nodiscard]] std::string relatedLatex(const Term &value, Fractions fractions = Fractions::Stacked);

} // namespace halfspace
