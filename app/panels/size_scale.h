// How large type, lines and handles are.
#pragma once

class QScreen;

namespace halfspace {

inline constexpr double smallestSizeScale = 1;
inline constexpr double largestSizeScale = 2.5;
inline constexpr double sizeScaleStep = 0.25;

/// What suits a screen. One with many dots that does not say so itself (the usual density, no scale) is made
/// for larger type and lines.
[[nodiscard]] double usualSizeScale(const QScreen &screen);

} // namespace halfspace
