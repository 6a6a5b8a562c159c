// The outlines of a font's glyphs as Qt's paths.
#pragma once

#include "widgets/formula/math_font.h"

#include <QPainterPath>

#include <cstdint>
#include <unordered_map>

namespace halfspace {

/// Lengths are in em, y points down, the origin is the glyph's. Keeps every outline that was asked for; for
/// one thread at a time.
class GlyphOutlines {
public:
  explicit GlyphOutlines(const math::MathFonts &fonts) : m_fonts(fonts) {}

  [[nodiscard]] const QPainterPath &outline(math::FontIndex font, math::GlyphId glyph) const;

private:
  const math::MathFonts &m_fonts;
  mutable std::unordered_map<std::uint64_t, QPainterPath> m_outlines;
};

} // namespace halfspace
