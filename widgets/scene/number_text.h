// Numbers as they are written at the axes.
#pragma once

#include <string>

namespace halfspace {

/// At most three digits after the point, none that say nothing; never −0.
[[nodiscard]] std::string numberText(double number);

} // namespace halfspace
