// How lengths are written into files.
#pragma once

#include <glm/vec2.hpp>

#include <string>

namespace halfspace {

/// A length in points with at most two decimals, without zeros at its end: 12.5, -0.03, 0.
[[nodiscard]] std::string pageNumber(double value);

/// Both, with something between.
[[nodiscard]] std::string pageNumbers(glm::dvec2 spot, const char *between = " ");

} // namespace halfspace
