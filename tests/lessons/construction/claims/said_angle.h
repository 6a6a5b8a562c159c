// Angles as sentences tell them.
#pragma once

#include "tests/lessons/construction/expected/recompute_tools.h"

#include <cmath>
#include <numbers>
#include <string>

namespace halfspace::test {

/// Whether an angle is told as far as it is written: ` = 90` is exact, ` ≈ 53.13` is the nearest number with
/// two decimals. Requires vectors ≠ 0.
[[nodiscard]] inline bool isAngleBetween(const ExactVec3 &a, const ExactVec3 &b, const std::string &told) {
  constexpr double roundingOfDoubles = 1e-9; // far more than that of one atan2, far less than what is written
  const ExactVec3 across = perpendicular(a, b);
  const double radians = std::atan2(std::sqrt(toDouble(product(across, across))), toDouble(product(a, b)));
  const double degrees = radians * 180 / std::numbers::pi;
  const std::string written = told.substr(told.find_first_of("0123456789"));
  const auto point = written.find('.');
  const auto decimals = point == std::string::npos ? 0 : written.size() - point - 1;
  const bool isExact = told.find('=') != std::string::npos;
  const double halfOfLastDigit = isExact ? 0 : std::pow(10.0, -static_cast<double>(decimals)) / 2;
  return std::abs(std::stod(written) - degrees) <= halfOfLastDigit + roundingOfDoubles;
}

} // namespace halfspace::test
