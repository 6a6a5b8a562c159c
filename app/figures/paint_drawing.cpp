#include "app/figures/paint_drawing.h"

#include "widgets/colors.h"
#include "widgets/exports/formula_outlines.h"

#include <QPainter>
#include <QPainterPath>

namespace halfspace {
namespace {

QPointF toPoint(glm::dvec2 spot) { return {spot.x, spot.y}; }

QPainterPath toPath(const PagePath &path) {
  QPainterPath painted;
  painted.setFillRule(Qt::WindingFill);
  for (const PageStep &step : path.steps)
    switch (step.kind) {
    case PageStep::Kind::Move:
      painted.moveTo(toPoint(step.to));
      break;
    case PageStep::Kind::Line:
      painted.lineTo(toPoint(step.to));
      break;
    case PageStep::Kind::Curve:
      painted.cubicTo(toPoint(step.first), toPoint(step.second), toPoint(step.to));
      break;
    case PageStep::Kind::Close:
      painted.closeSubpath();
      break;
    }
  return painted;
}

QColor toQColor(Color color, double opacity) {
  QColor seen = toQColor(color);
  seen.setAlphaF(opacity);
  return seen;
}

/// Qt measures dashes in widths of the pen.
QPen toPen(const Pen &pen) {
  QPen painted(toQColor(pen.color, pen.opacity), pen.width, Qt::SolidLine,
               pen.cap == Pen::Cap::Flat ? Qt::FlatCap : Qt::RoundCap, Qt::RoundJoin);
  if (pen.dashes.empty())
    return painted;
  QVector<qreal> inWidths;
  for (const double dash : pen.dashes)
    inWidths << dash / pen.width;
  painted.setDashPattern(inWidths);
  painted.setDashOffset(pen.dashStart / pen.width);
  return painted;
}

void paint(QPainter &painter, const PathPart &part, const math::MathFonts &) {
  painter.setBrush(part.fill ? QBrush(toQColor(part.fill->color, part.fill->opacity)) : QBrush(Qt::NoBrush));
  painter.setPen(part.pen ? toPen(*part.pen) : QPen(Qt::NoPen));
  painter.drawPath(toPath(part.path));
}

void paint(QPainter &painter, const FormulaPart &part, const math::MathFonts &fonts) {
  const std::vector<InkedOutline> outlines = outlinesOf(part, fonts);
  painter.setOpacity(part.opacity);
  painter.setPen(
      QPen(toQColor(part.halo), 2 * haloWidth * part.size, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(toQColor(part.halo));
  for (const InkedOutline &outline : outlines)
    painter.drawPath(toPath(outline.path));
  painter.setPen(Qt::NoPen);
  for (const InkedOutline &outline : outlines) {
    painter.setBrush(toQColor(outline.ink));
    painter.drawPath(toPath(outline.path));
  }
  painter.setOpacity(1);
}

} // namespace

void paintDrawing(QPainter &painter, const Drawing &drawing, const math::MathFonts &fonts) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (drawing.ground)
    painter.fillRect(QRectF(0, 0, drawing.size.x, drawing.size.y), toQColor(*drawing.ground));
  for (const DrawingPart &part : drawing.parts)
    std::visit([&](const auto &one) { paint(painter, one, fonts); }, part);
}

} // namespace halfspace
