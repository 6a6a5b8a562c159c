// Terms as presentation MathML, for pages of the web and for documents. All of it is in MathML Core.
#pragma once

#include "lessons/term/chain.h"

#include <string>
#include <vector>

namespace halfspace {

/// A whole `<math>` element. A term that is a mark of the figure carries its id as `data-mark`.
[[nodiscard]] std::string mathMl(const Term &term);
[[nodiscard]] std::string mathMl(const Chain &chain);

/// The sides from `begin` on, each but the chain's first with the relation before it, to stand in a `<math>`
/// element. They carry no ids of marks: these mean nothing in a document.
[[nodiscard]] std::string mathMlRow(const Chain &chain, std::size_t begin, std::size_t end);
/// Rows beside each other, with commas between them, as a `<math>` element on a line of its own.
[[nodiscard]] std::string displayedMathMl(const std::vector<std::string> &rows);

} // namespace halfspace
