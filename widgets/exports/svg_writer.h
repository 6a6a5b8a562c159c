// Drawings as SVG.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/formula/math_font.h"

namespace halfspace {

enum class SvgText {
  Shapes, ///< looks the same everywhere
  Letters ///< can be searched and edited where the reader has the font
};

/// One document, whose parts can be told by their marks (`data-mark`), and what is hidden by its class. The
/// fonts are those that the drawing's formulas are set in.
[[nodiscard]] std::string svgOf(const Drawing &drawing, const math::MathFonts &fonts,
                                SvgText text = SvgText::Shapes);

} // namespace halfspace
