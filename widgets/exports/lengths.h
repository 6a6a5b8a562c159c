// Lengths on paper, which are in points.
#pragma once

namespace halfspace {

inline constexpr double pointsPerInch = 72;
inline constexpr double pointsPerMillimetre = pointsPerInch / 25.4;
inline constexpr double pointsPerCentimetre = pointsPerInch / 2.54;

} // namespace halfspace
