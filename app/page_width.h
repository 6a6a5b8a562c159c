// How the window's width is shared between the scene and the page.
#pragma once

#include <QFontMetrics>
#include <QSize>

#include <algorithm>

namespace halfspace {

// Of a page, in letters of its type.
inline constexpr int usualPageLetters = 59;
inline constexpr int leastPageLetters = 30;
// Of the window.
inline constexpr double mostPageShare = 0.36;      ///< of a page with the usual letters
inline constexpr double mostNarrowPageShare = 0.5; ///< of one with the least: large type in a small window
inline constexpr double pageShareBelow = 0.46;     ///< of its height, where the page goes below the scene

/// Whether the page stands below the scene: where the window is higher than wide.
[[nodiscard]] inline bool isPageBelow(QSize window) { return window.height() > window.width(); }

/// The width of the page beside the scene, of what both have together, in pixels: usual lines, but no more
/// than its share, unless fewer than the least letters would be left.
[[nodiscard]] inline int pageWidthIn(int whole, const QFontMetrics &type) {
  const int letter = type.averageCharWidth();
  const int least = std::min(leastPageLetters * letter, static_cast<int>(mostNarrowPageShare * whole));
  const int most = std::max(least, static_cast<int>(mostPageShare * whole));
  return std::clamp(usualPageLetters * letter, least, most);
}

} // namespace halfspace
