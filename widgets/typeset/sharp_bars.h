// Makes the horizontal strokes of a glyph sharp.
#pragma once

#include <QPainterPath>

namespace halfspace {

/// The outline of a glyph in pixels with its long horizontal strokes (of =, −, +, arrows, 4) moved onto whole
/// rows of pixels, each a whole number of rows thick once its edges are drawn with a pen so wide; what lies
/// between is stretched a little. `em` is the type's size.
[[nodiscard]] QPainterPath withSharpBars(QPainterPath outline, double em, double pen);

} // namespace halfspace
