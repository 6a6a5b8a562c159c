// Counts and measurements in sentences, with the marks of the language that the user is addressed in.
#pragma once

#include <QString>

#include <cstddef>

namespace halfspace {

/// 1,000,000
[[nodiscard]] QString counted(std::size_t count);
/// The count for `tr`, which chooses by it among the forms that a translation has; English has one, and
/// `counted` writes the number.
[[nodiscard]] int formOf(std::size_t count);
/// 1 triangle, 1,000 triangles
[[nodiscard]] QString trianglesInWords(std::size_t count);
/// A measurement ≥ 0 to so many digits at the most, without powers of ten: 0.012, 12,300.
[[nodiscard]] QString roundedText(double value, int digits);
/// The same, after ≈ where it has more digits.
[[nodiscard]] QString measuredText(double value, int digits);

} // namespace halfspace
