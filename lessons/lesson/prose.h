// The LaTeX among a lesson's words as plain text. Formulas of our own are terms, and need no reading.
#pragma once

#include "lessons/lesson/macros.h"

#include <string>

namespace halfspace {

/// A formula as one line of plain text: `\frac{f(Q)}{\lvert\vec n\rvert}` is f(Q)/|n|. What is no LaTeX that
/// lessons use stands as it is.
[[nodiscard]] std::string plainProse(const std::string &latex, const Macros &macros = {});

} // namespace halfspace
