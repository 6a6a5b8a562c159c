// What formulas are set in: the fonts, and their glyphs as outlines and images.
#pragma once

#include "widgets/typeset/glyph_images.h"

namespace halfspace {

/// The fonts that the program carries with it. For one thread at a time.
class MathTypeface {
public:
  MathTypeface();

  [[nodiscard]] const math::MathFonts &fonts() const { return m_fonts; }
  [[nodiscard]] const GlyphOutlines &outlines() const { return m_outlines; }
  [[nodiscard]] const GlyphImages &images() const { return m_images; }

private:
  math::MathFonts m_fonts;
  GlyphOutlines m_outlines{m_fonts};
  GlyphImages m_images{m_outlines};
};

} // namespace halfspace
