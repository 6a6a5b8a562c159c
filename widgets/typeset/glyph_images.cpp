#include "widgets/typeset/glyph_images.h"

#include "widgets/typeset/sharp_bars.h"

#include <QPainter>

#include <algorithm>
#include <memory>

namespace halfspace {
namespace {

/// What an image costs apart from its texels.
constexpr int bytesBeside = 128;

GlyphImage draw(const QPainterPath &outline, const GlyphLook &look) {
  const double scale = static_cast<double>(look.size) / GlyphLook::partsPerPixel;
  const double thicker = static_cast<double>(look.thicker) / GlyphLook::partsPerPixel;
  const QPainterPath path =
      withSharpBars(QTransform(scale, 0, 0, scale, look.quarter / 4.0, 0).map(outline), scale, thicker);
  if (path.isEmpty())
    return {};
  const QRect room = path.boundingRect().adjusted(-thicker, -thicker, thicker, thicker).toAlignedRect();
  QImage image(room.size(), QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(-room.topLeft());
  const QColor color = QColor::fromRgba(look.color);
  painter.setBrush(color);
  painter.setPen(QPen(color, thicker, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  return {image, room.topLeft()};
}

} // namespace

uint qHash(const GlyphLook &look, uint seed) {
  const auto mix = [&seed](auto value) { seed = (seed ^ static_cast<uint>(value)) * 0x9E3779B1U; };
  mix(look.glyph << 3 | static_cast<uint>(look.font) << 2 | static_cast<uint>(look.quarter));
  mix(look.size);
  mix(look.thicker);
  mix(look.color);
  return seed ^ seed >> 16;
}

const GlyphImage &GlyphImages::image(const GlyphLook &look) const {
  if (const GlyphImage *known = m_images.object(look))
    return *known;
  auto made = std::make_unique<GlyphImage>(draw(m_outlines.outline(look.font, look.glyph), look));
  // What costs more than the whole cache would be deleted at once.
  const int cost = static_cast<int>(std::min<qsizetype>(made->image.sizeInBytes() + bytesBeside, mostBytes));
  GlyphImage *kept = made.release();
  m_images.insert(look, kept, cost);
  return *kept;
}

} // namespace halfspace
