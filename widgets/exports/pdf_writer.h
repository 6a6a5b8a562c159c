// Drawings as PDF.
#pragma once

#include "widgets/exports/drawing.h"
#include "widgets/formula/math_font.h"

namespace halfspace {

/// A file of one page as large as the drawing: a tagged figure, described in words. Its formulas are text in
/// an embedded part of the fonts, which are those that they are set in, and are copied as their plain text.
[[nodiscard]] std::string pdfOf(const Drawing &drawing, const math::MathFonts &fonts);

/// The entries of a figure's element: its description, and the box that it takes on its page.
[[nodiscard]] std::string figureEntries(const std::string &description, const std::string &box);

} // namespace halfspace
