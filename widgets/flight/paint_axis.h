// A flight's axis on a painter.
#pragma once

#include "widgets/flight/axis_layout.h"
#include "widgets/typeset/math_picture.h"

namespace halfspace {

/// What is painted; all that it refers to must outlive it.
struct PaintedAxis {
  const AxisLayout &layout;
  const MathPicture &parameter; ///< the letter at the arrow
  const MathPicture &start;     ///< and that at 0
  const Theme &theme;
  std::size_t hovered; ///< the number of a fragment; 0 for none
  bool hasFocus;
};

/// The line with its ticks, the pins and the torpedo, in words of the painter's font.
void paintAxis(QPainter &painter, const PaintedAxis &axis);

} // namespace halfspace
