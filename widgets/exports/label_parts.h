// What is written into a figure, with the lines that lead to it.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/picture/shapes/shape.h"

namespace halfspace {

[[nodiscard]] std::vector<DrawingPart> labelParts(const std::vector<Shape> &labels, double pointsPerPixel);

} // namespace halfspace
