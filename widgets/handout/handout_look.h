// How the pages of a handout are laid out. Lengths are in points.
#pragma once

#include <glm/vec2.hpp>

namespace halfspace {

enum class HandoutPaper { A4, Letter };

struct HandoutLook {
  glm::dvec2 page{};
  double side = 0;   ///< the margin at either side
  double top = 0;    ///< from the page's upper end to the text
  double bottom = 0; ///< from the text to the page's lower end
  int columns = 1;
  double gutter = 0;   ///< between columns
  double typeSize = 0; ///< of running text
  bool isJustified = false;

  [[nodiscard]] double textWidth() const { return page.x - 2 * side; }
  [[nodiscard]] double textHeight() const { return page.y - top - bottom; }
  [[nodiscard]] double columnWidth() const { return (textWidth() - (columns - 1) * gutter) / columns; }
  [[nodiscard]] double columnLeft(int column) const { return side + column * (columnWidth() + gutter); }
  /// The distance between the baselines of running text.
  [[nodiscard]] double leading() const { return leadingEms * typeSize; }

  static constexpr double leadingEms = 1.27;
};

/// One column has lines of some 75 letters that are justified. Without hyphens narrow columns cannot be: of
/// two, the lines end where they end.
[[nodiscard]] HandoutLook handoutLook(HandoutPaper paper, int columns);

} // namespace halfspace
