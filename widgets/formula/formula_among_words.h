// Formulas as they are set among words.
#pragma once

#include "lessons/lesson/filled_markdown.h"
#include "widgets/formula/math_tree.h"

#include <optional>

namespace halfspace {

/// The formula with what follows it: in display style where it is large, else as in a line of text. Nothing
/// where its LaTeX cannot be read.
[[nodiscard]] std::optional<math::Row> rowAmongWords(const FilledFormula &formula, const Macros &macros);

} // namespace halfspace
