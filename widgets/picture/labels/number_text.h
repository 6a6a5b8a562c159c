// Numbers as they are written at the axes.
#pragma once

#include <string>

namespace halfspace {

/// number·10^exponent in LaTeX: as a decimal with at most three digits after the point, none that say
/// nothing, never −0; where it is too large or too small for that, as 2.5 \cdot 10^{7}. Behind ≈ where digits
/// were left out.
[[nodiscard]] std::string numberText(double number, int exponent = 0);

} // namespace halfspace
