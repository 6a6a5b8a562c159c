// Drawings as SVG.
#pragma once

#include "widgets/exports/format.h"

namespace halfspace {

/// One document, whose parts can be told by their marks (`data-mark`), and what is hidden by its class. The
/// fonts are those that the drawing's formulas are set in.
[[nodiscard]] std::string svgOf(const Drawing &drawing, const math::MathFonts &fonts,
                                TextAs text = TextAs::Shapes);

} // namespace halfspace
