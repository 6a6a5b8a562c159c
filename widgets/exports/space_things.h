// Lines, arrows and points of a figure in space, as they are drawn on paper.
#pragma once

#include "widgets/exports/drawn_lines.h"

namespace halfspace {

/// What of these shapes is thin, round or pointed, in their order.
[[nodiscard]] std::vector<PaintedThing> thingsOf(const std::vector<Shape> &shapes, const LineRoom &room);

} // namespace halfspace
