// Terms as LaTeX, in plain commands that every installation knows.
#pragma once

#include "lessons/term/chain.h"
#include "lessons/term/fractions.h"
#include "lessons/term/written.h"

#include <string>

namespace halfspace {

[[nodiscard]] std::string latexOf(const Term &term, Fractions fractions = Fractions::Stacked);
[[nodiscard]] std::string latexOf(const Chain &chain, Fractions fractions = Fractions::Stacked);
/// The sides from `begin` on, each but the chain's first with the relation before it.
[[nodiscard]] std::string latexOf(const Chain &chain, std::size_t begin, std::size_t end,
                                  Fractions fractions = Fractions::Stacked);
[[nodiscard]] std::string latexOf(const Symbol &symbol);

/// A decimal with the language's mark: 3.14, or 3{,}14, as behind a comma LaTeX leaves a gap else.
[[nodiscard]] std::string latexDecimal(const std::string &decimal);

/// The value behind the relation that it allows: ` = 10`, ` \approx 3.16228`.
[[nodiscard]] std::string relatedLatex(const Term &value, Fractions fractions = Fractions::Stacked);
/// An angle's degrees behind their relation: `= 60^{\circ}`.
[[nodiscard]] std::string degreesLatex(const WrittenNumber &degrees);

} // namespace halfspace
