// A small square of a colour.
#pragma once

#include <QIcon>
#include <QPixmap>

namespace halfspace {

/// As it is, in selected rows too.
[[nodiscard]] inline QIcon swatchOf(const QColor &color) {
  constexpr int side = 12; // pixels
  QPixmap square(side, side);
  square.fill(color);
  QIcon icon(square);
  icon.addPixmap(square, QIcon::Selected);
  return icon;
}

} // namespace halfspace
