#include "widgets/typeset/paint_formula.h"

#include <QPaintEngine>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <optional>

namespace halfspace {
namespace {

/// Glyphs with a larger em, in pixels, are drawn as outlines: there are few of them, and their images are
/// big.
constexpr double largestImage = 128;

/// By how much strokes are wider than in the font, in em of the formula; `size` is that of their glyph's em.
double thicker(const FormulaLook &look, double size = 1) { return screenWeight * size + 2 * look.rim; }

/// How many pixels a unit of the painter has, where what it draws on has pixels and it neither turns nor
/// distorts.
std::optional<double> pixelsOf(const QPainter &painter) {
  const QPaintEngine *engine = painter.paintEngine();
  const QTransform &device = painter.deviceTransform();
  const bool isUpright =
      device.type() <= QTransform::TxScale && device.m11() > 0 && qFuzzyCompare(device.m11(), device.m22());
  return engine && engine->type() == QPaintEngine::Raster && isUpright ? std::optional(device.m11())
                                                                       : std::nullopt;
}

/// Draws in pixels.
class PixelPainter {
public:
  PixelPainter(QPainter &painter, const MathTypeface &typeface, const FormulaLook &look, double pixels)
      : m_painter(painter), m_images(typeface.images()), m_look(look), m_em(look.emPixels * pixels) {
    const QTransform device = painter.deviceTransform();
    m_origin = device.map(look.baseline);
    // The baseline stands on a whole pixel, so that formulas in a row are equally crisp.
    m_origin.setY(std::round(m_origin.y()));
    painter.save();
    painter.setWorldTransform(device.inverted() * painter.worldTransform());
  }
  ~PixelPainter() { m_painter.restore(); }
  PixelPainter(const PixelPainter &) = delete;
  PixelPainter &operator=(const PixelPainter &) = delete;

  void paint(const math::PlacedGlyph &glyph) const {
    const int x = quarters(m_origin.x() + glyph.x * m_em);
    const int y = static_cast<int>(std::lround(m_origin.y() + glyph.y * m_em));
    const GlyphImage &drawn =
        m_images.image({glyph.font, glyph.glyph, parts(glyph.size), parts(thicker(m_look, glyph.size)), x & 3,
                        m_look.color(glyph.ink).rgba()});
    if (!drawn.image.isNull())
      m_painter.drawImage(QPoint(x >> 2, y) + drawn.leftTop, drawn.image);
  }

  /// Whole pixels thick, and ending where a rule across, as thick and flush with it, has its outer edge.
  void paint(const math::Rule &rule) const {
    const double thickness = std::min(rule.box.width, rule.box.height);
    const int pixels = std::max(1, static_cast<int>(std::lround((thickness + thicker(m_look)) * m_em)));
    const double inset = (thickness * m_em - pixels) / 2;
    const auto first = [&](double place) { return static_cast<int>(std::lround(place + inset)); };
    const auto behind = [&](double place) {
      return static_cast<int>(std::lround(place - inset - pixels)) + pixels;
    };
    const QPoint leftTop(first(m_origin.x() + rule.box.x * m_em), first(m_origin.y() + rule.box.y * m_em));
    const QPoint rightBottom(behind(m_origin.x() + rule.box.right() * m_em) - 1,
                             behind(m_origin.y() + rule.box.bottom() * m_em) - 1);
    m_painter.fillRect(QRect(leftTop, rightBottom), m_look.color(rule.ink));
  }

private:
  static int quarters(double place) { return static_cast<int>(std::floor(place * 4 + 0.5)); }
  [[nodiscard]] int parts(double em) const {
    return static_cast<int>(std::lround(em * m_em * GlyphLook::partsPerPixel));
  }
  QPainter &m_painter;
  const GlyphImages &m_images;
  const FormulaLook &m_look;
  double m_em;
  QPointF m_origin;
};

void paintOutlines(QPainter &painter, const math::Layout &formula, const MathTypeface &typeface,
                   const FormulaLook &look) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(look.baseline);
  painter.scale(look.emPixels, look.emPixels);
  const QTransform toPainter = painter.transform();
  const auto setColor = [&](const math::Ink &ink, double stroke) {
    const QColor color = look.color(ink);
    painter.setBrush(color);
    painter.setPen(QPen(color, stroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  };
  for (const math::PlacedGlyph &glyph : formula.glyphs) {
    setColor(glyph.ink, thicker(look, glyph.size) / glyph.size);
    painter.setTransform(QTransform(glyph.size, 0, 0, glyph.size, glyph.x, glyph.y) * toPainter);
    painter.drawPath(typeface.outlines().outline(glyph.font, glyph.glyph));
  }
  painter.setTransform(toPainter);
  for (const math::Rule &rule : formula.rules) {
    setColor(rule.ink, thicker(look));
    painter.drawRect(QRectF(rule.box.x, rule.box.y, rule.box.width, rule.box.height));
  }
  painter.restore();
}

} // namespace

void paintFormula(QPainter &painter, const math::Layout &formula, const MathTypeface &typeface,
                  const FormulaLook &look) {
  const std::optional<double> pixels = pixelsOf(painter);
  if (!pixels || look.emPixels * *pixels > largestImage)
    return paintOutlines(painter, formula, typeface, look);
  const PixelPainter inPixels(painter, typeface, look, *pixels);
  for (const math::PlacedGlyph &glyph : formula.glyphs)
    inPixels.paint(glyph);
  for (const math::Rule &rule : formula.rules)
    inPixels.paint(rule);
}

} // namespace halfspace
