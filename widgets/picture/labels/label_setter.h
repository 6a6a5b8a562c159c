// Labels set in type.
#pragma once

#include "widgets/formula/math_font.h"
#include "widgets/picture/labels/label_picture.h"

namespace halfspace {

/// Sets a piece of LaTeX in type; never null. The same LaTeX gives the same object again for as long as it is
/// in use from frame to frame.
using LabelSetter = std::function<LabelFormula(const std::string &latex)>;

/// Sets labels and keeps the latest. The fonts must outlive it; it is for one thread at a time, as they are.
[[nodiscard]] LabelSetter labelSetter(const math::MathFonts &fonts);

} // namespace halfspace
