// Drawings as TikZ.
#pragma once

#include "widgets/exports/drawing.h"

namespace halfspace {

/// A file that LaTeX makes a page of as large as the drawing, and that a document which has TikZ and amsmath
/// takes in with \input. Formulas are LaTeX: they are set in the document's own type.
[[nodiscard]] std::string tikzOf(const Drawing &drawing);

} // namespace halfspace
