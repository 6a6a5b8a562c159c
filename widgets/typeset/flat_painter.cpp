#include "widgets/typeset/flat_painter.h"

#include "widgets/colors.h"
#include "widgets/picture/shapes/flat_shapes.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <QImage>
#include <QPainter>

#include <new>

namespace halfspace {
namespace {

QPointF toPoint(glm::dvec2 pixel) { return {pixel.x, pixel.y}; }

QPen penOf(const FlatShape &shape) {
  const bool isDashed = !shape.rhythm.empty();
  QPen pen(toQColor(shape.color), shape.width, Qt::SolidLine, isDashed ? Qt::FlatCap : Qt::RoundCap,
           Qt::MiterJoin);
  if (isDashed) {
    QVector<qreal> inWidths;
    for (const double length : shape.rhythm)
      inWidths << length / shape.width;
    pen.setDashPattern(inWidths);
  }
  return pen;
}

void paintShape(QPainter &painter, const FlatShape &shape) {
  QPolygonF path;
  for (const glm::dvec2 &pixel : shape.path)
    path << toPoint(pixel);
  painter.setOpacity(shape.opacity);
  const bool isFilled = shape.isDisc || shape.width == 0;
  painter.setBrush(isFilled ? QBrush(toQColor(shape.color)) : QBrush(Qt::NoBrush));
  painter.setPen(isFilled ? QPen(Qt::NoPen) : penOf(shape));
  if (shape.isDisc)
    painter.drawEllipse(path.first(), shape.width / 2, shape.width / 2);
  else if (isFilled || shape.isClosed)
    painter.drawPolygon(path);
  else
    painter.drawPolyline(path);
}

void paintLabel(QPainter &painter, const LabelOnPage &label, const MathPicture &formula) {
  const LabelStyle &style = label.text.style;
  painter.setOpacity(label.text.opacity);
  if (const auto leader = leaderOf(label.place)) {
    painter.setPen(QPen(toQColor(style.ink), leaderWidth));
    painter.drawLine(toPoint(leader->from), toPoint(leader->to));
  }
  const LabelRoom room = roomOf(*label.formula, style);
  const QPointF baseline = toPoint(label.place.topLeft) + QPointF(room.left, room.baseline);
  formula.paintHalo(painter, baseline, style.pixelSize, haloWidth * style.pixelSize, toQColor(style.halo));
  formula.paint(painter, baseline, style.pixelSize, [&](const QString &) { return toQColor(style.ink); });
}

} // namespace

FlatPainter::FlatPainter(const Typesetter &typesetter)
    : m_typesetter(typesetter), m_set(labelSetter(typesetter.fonts())) {}

void FlatPainter::paint(QPainter &painter, const SceneContent &content, const Theme &theme,
                        const View &view) {
  painter.setRenderHint(QPainter::Antialiasing);
  for (const FlatShape &shape : flatShapes(content, theme, view))
    paintShape(painter, shape);
  const auto texts = writtenLabels(content, {}, theme, view);
  for (const LabelOnPage &label :
       m_page.place(texts, obstaclesOf(content, std::nullopt, theme, view), m_set, view))
    paintLabel(painter, label, *m_typesetter.picture(label.formula));
  painter.setOpacity(1);
}

RgbaImage drawFlat(const SceneContent &content, const Theme &theme, const View &view, bool isTransparent,
                   const Typesetter &typesetter) {
  QImage image(view.size.width, view.size.height, QImage::Format_ARGB32_Premultiplied);
  if (image.isNull()) // as Qt tells it
    throw std::bad_alloc();
  image.fill(isTransparent ? Qt::transparent : toQColor(theme.panel));
  QPainter painter(&image);
  FlatPainter(typesetter).paint(painter, content, theme, view);
  painter.end();
  return fromImage(image);
}

} // namespace halfspace
