// Draws formulas that are laid out.
#pragma once

#include "widgets/formula/layout.h"
#include "widgets/typeset/math_typeface.h"

#include <QColor>
#include <QPointF>

#include <functional>

class QPainter;

namespace halfspace {

/// Where and how a formula is drawn.
struct FormulaLook {
  QPointF baseline;    ///< its left end
  double emPixels = 0; ///< the painter's units of an em
  double rim = 0;      ///< em by which every shape reaches farther on all sides
  std::function<QColor(const math::Ink &)> color;
};

/// The fonts are made for fine printing: on a screen strokes need so much more, in em of the glyph.
inline constexpr double screenWeight = 0.016;

/// On an image or a widget of which every pixel is a pixel: letters as images on whole rows of pixels, and
/// sharp rules. Elsewhere (on paper, in vector files, turned, or very large) outlines.
void paintFormula(QPainter &painter, const math::Layout &formula, const MathTypeface &typeface,
                  const FormulaLook &look);

} // namespace halfspace
