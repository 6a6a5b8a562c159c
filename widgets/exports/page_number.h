// How lengths are written into files.
#pragma once

#include <glm/vec2.hpp>

#include <string>

namespace halfspace {

/// Lengths are written in hundredths of a point.
inline constexpr int writtenPerPoint = 100;
/// What is no longer than this, in points, has no length in a file.
inline constexpr double leastWritten = 1.0 / writtenPerPoint;

/// A length in points with at most two decimals, without zeros at its end: 12.5, -0.03, 0.
[[nodiscard]] std::string pageNumber(double value);

/// Both, with something between.
[[nodiscard]] std::string pageNumbers(glm::dvec2 spot, const char *between = " ");

} // namespace halfspace
