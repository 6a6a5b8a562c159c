#include "widgets/typeset/glyph_outlines.h"

namespace halfspace {
namespace {

QPointF toQt(math::PathStep::Point point) { return {point.x, -point.y}; }

void append(QPainterPath &path, const math::PathStep &step) {
  using Kind = math::PathStep::Kind;
  switch (step.kind) {
  case Kind::Move:
    return path.moveTo(toQt(step.a));
  case Kind::Line:
    return path.lineTo(toQt(step.a));
  case Kind::Quad:
    return path.quadTo(toQt(step.a), toQt(step.b));
  case Kind::Cubic:
    return path.cubicTo(toQt(step.a), toQt(step.b), toQt(step.c));
  case Kind::Close:
    return path.closeSubpath();
  }
}

} // namespace

const QPainterPath &GlyphOutlines::outline(math::FontIndex font, math::GlyphId glyph) const {
  const auto key = std::uint64_t{static_cast<std::uint8_t>(font)} << 32 | glyph;
  const auto [known, isNew] = m_outlines.try_emplace(key);
  if (isNew) {
    known->second.setFillRule(Qt::WindingFill);
    for (const math::PathStep &step : m_fonts.face(font).outline(glyph))
      append(known->second, step);
  }
  return known->second;
}

} // namespace halfspace
