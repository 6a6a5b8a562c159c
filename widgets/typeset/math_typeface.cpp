#include "widgets/typeset/math_typeface.h"

#include "widgets/typeset/embedded_font.h"

namespace halfspace {

MathTypeface::MathTypeface()
    : m_fonts{math::MathFont::from(math::FontFace::fromMemory(embeddedFont("math.otf")).value()).value(),
              math::FontFace::fromMemory(embeddedFont("text.ttf"))} {}

} // namespace halfspace
