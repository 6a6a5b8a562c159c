// Paints drawings, as the files that they are written to are shown.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/formula/math_font.h"

class QPainter;

namespace halfspace {

/// In the painter's units a point is one. The fonts are those that the drawing's formulas are set in.
void paintDrawing(QPainter &painter, const Drawing &drawing, const math::MathFonts &fonts);

} // namespace halfspace
