// How the window's width is shared between the scene and the page.
#pragma once

#include "app/panels/size_scale.h"

#include <QFontMetrics>
#include <QSize>

#include <algorithm>
#include <cmath>

namespace halfspace {

// Of a page, in letters of its type.
inline constexpr int usualPageLetters = 59;
inline constexpr int leastPageLetters = 30;
// Of the window.
inline constexpr double mostPageShare = 0.36;      ///< of a page with the usual letters
inline constexpr double mostWidePageShare = 0.42;  ///< the same where the scene stays wide beside it
inline constexpr double mostNarrowPageShare = 0.5; ///< of one with the least: large type in a small window
inline constexpr double pageShareBelow = 0.46;     ///< of its height, where the page goes below the scene
/// Of a page that stands alone: its longest lines take no more.
inline constexpr double mostLineShareAlone = 0.6;
inline constexpr double mostTypeScaleAlone = 1.5;

/// Whether the page stands below the scene: where the window is higher than wide.
[[nodiscard]] inline bool isPageBelow(QSize window) { return window.height() > window.width(); }

/// A scene is wide from here on, in pixels.
inline constexpr int wideScene = 650;

/// The most that a page with the usual letters takes of what it and the scene have together.
[[nodiscard]] inline int mostPageWidth(int whole) {
  const int besideWideScene = std::min(static_cast<int>(mostWidePageShare * whole), whole - wideScene);
  return std::max(static_cast<int>(mostPageShare * whole), besideWideScene);
}

/// The width of the page beside the scene, of what both have together, in pixels: usual lines, but no more
/// than its share, unless fewer than the least letters would be left.
[[nodiscard]] inline int pageWidthIn(int whole, const QFontMetrics &type) {
  const int letter = type.averageCharWidth();
  const int least = std::min(leastPageLetters * letter, static_cast<int>(mostNarrowPageShare * whole));
  const int most = std::max(least, mostPageWidth(whole));
  return std::clamp(usualPageLetters * letter, least, most);
}

/// How much larger the type of a page is that stands alone, where its longest lines have this width in usual
/// type. It grows with the window in steps of `sizeScaleStep`, so that lines do not break anew at every
/// pixel.
[[nodiscard]] inline double typeScaleAlone(int whole, int longestLine) {
  const double fitting = mostLineShareAlone * whole / longestLine;
  const double stepped = std::floor(fitting / sizeScaleStep) * sizeScaleStep;
  return std::clamp(stepped, 1.0, mostTypeScaleAlone);
}

} // namespace halfspace
