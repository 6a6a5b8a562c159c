#include "widgets/typeset/math_picture.h"

#include "widgets/typeset/svg_reader.h"

#include <QFont>
#include <QFontMetricsF>
#include <QPainter>

namespace halfspace {

MathPicture MathPicture::fromSvg(const QString &svg, const QString &latex) {
  MathPicture picture = SvgReader(svg).read();
  return picture.error().isEmpty() ? picture : failed(picture.error(), latex);
}

MathPicture MathPicture::failed(const QString &error, const QString &latex) {
  // A source is cut to what fits on a line.
  constexpr int longestSource = 60;
  constexpr double fontPixels = 100; // large, so that hinting does not deform the outlines
  QFont font(QStringLiteral("monospace"));
  font.setStyleHint(QFont::TypeWriter);
  font.setPixelSize(static_cast<int>(fontPixels));
  QString source = latex.left(longestSource).simplified();
  if (latex.size() > longestSource)
    source += QChar(u'…');
  QPainterPath outlines;
  outlines.addText({0, 0}, font, source);

  constexpr double smaller = 0.85; // typewriter letters look larger than a formula's
  constexpr double exPerPixel = smaller / (exPerEm * fontPixels);
  const QFontMetricsF metrics(font);
  MathPicture picture;
  Item item;
  item.path = QTransform::fromScale(exPerPixel, exPerPixel).map(outlines);
  item.path.setFillRule(Qt::WindingFill);
  picture.m_items.push_back(item);
  picture.m_width = metrics.horizontalAdvance(source) * exPerPixel;
  picture.m_ascent = metrics.ascent() * exPerPixel;
  picture.m_depth = metrics.descent() * exPerPixel;
  picture.m_error = error;
  return picture;
}

namespace {

void prepare(QPainter &painter, QPointF baseline, double exPixels) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(baseline);
  painter.scale(exPixels, exPixels);
}

} // namespace

void MathPicture::paint(QPainter &painter, QPointF baseline, double exPixels, const InkOf &inkOf) const {
  painter.save();
  prepare(painter, baseline, exPixels);
  for (const Item &item : m_items) {
    const QColor ink = inkOf(item.mark);
    painter.save();
    if (!item.clip.isNull())
      painter.setClipRect(item.clip, Qt::IntersectClip);
    if (item.strokeWidth > 0)
      painter.strokePath(item.path, QPen(ink, item.strokeWidth, item.dash, Qt::FlatCap, Qt::MiterJoin));
    else
      painter.fillPath(item.path, ink);
    painter.restore();
  }
  painter.restore();
}

void MathPicture::paintHalo(QPainter &painter, QPointF baseline, double exPixels, double width,
                            const QColor &color) const {
  painter.save();
  prepare(painter, baseline, exPixels);
  for (const Item &item : m_items) {
    const QPen pen(color, item.strokeWidth + 2 * width / exPixels, Qt::SolidLine, Qt::RoundCap,
                   Qt::RoundJoin);
    painter.save();
    if (!item.clip.isNull()) {
      const double margin = width / exPixels;
      painter.setClipRect(item.clip.adjusted(-margin, -margin, margin, margin), Qt::IntersectClip);
    }
    painter.strokePath(item.path, pen);
    painter.restore();
  }
  painter.restore();
}

} // namespace halfspace
