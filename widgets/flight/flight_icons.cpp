#include "widgets/flight/flight_icons.h"

#include "widgets/drawn_icon.h"

#include <QTransform>

namespace halfspace {
namespace {

QPainterPath polygon(const QPolygonF &corners) {
  QPainterPath path;
  path.addPolygon(corners);
  path.closeSubpath();
  return path;
}

QPainterPath bar(double left) {
  QPainterPath path;
  path.addRect(left, 3, 1.8, 10);
  return path;
}

/// What is filled.
QPainterPath bodyOf(FlightIcon icon) {
  switch (icon) {
  case FlightIcon::Fire: {
    return QTransform::fromTranslate(15.2, 8).scale(11, 11).map(torpedo());
  }
  case FlightIcon::Play:
    return polygon(QPolygonF({{4.5, 3}, {13, 8}, {4.5, 13}}));
  case FlightIcon::Pause:
    return bar(4.5) + bar(9.7);
  case FlightIcon::StepBack:
    return polygon(QPolygonF({{9.5, 3.5}, {2.5, 8}, {9.5, 12.5}})) + bar(11.4);
  case FlightIcon::StepForward:
    return polygon(QPolygonF({{6.5, 3.5}, {13.5, 8}, {6.5, 12.5}})) + bar(2.8);
  case FlightIcon::Automatic:
    break;
  }
  return polygon(QPolygonF({{10.3, 4.6}, {14.6, 4.9}, {12.6, 8.7}})); // the tip of the circle's arrow
}

QPainterPath strokesOf(FlightIcon icon) {
  QPainterPath path;
  if (icon == FlightIcon::Automatic) {
    const QRectF circle(2.5, 2.5, 11, 11);
    path.arcMoveTo(circle, 20);
    path.arcTo(circle, 20, 300);
  }
  if (icon == FlightIcon::Fire) // what it leaves behind
    for (const QLineF &trace :
         {QLineF(0.9, 8, 2.6, 8), QLineF(1.9, 5.2, 3.4, 5.2), QLineF(1.9, 10.8, 3.4, 10.8)}) {
      path.moveTo(trace.p1());
      path.lineTo(trace.p2());
    }
  return path;
}

} // namespace

QIcon iconOf(FlightIcon icon, const QColor &ink) { return drawnIcon(strokesOf(icon), ink, bodyOf(icon)); }

QPainterPath torpedo() {
  QPainterPath path;
  path.moveTo(0, 0);
  path.cubicTo(-0.08, -0.13, -0.22, -0.2, -0.42, -0.2);
  path.lineTo(-0.72, -0.2);
  path.lineTo(-1, -0.36);
  path.lineTo(-0.9, 0);
  path.lineTo(-1, 0.36);
  path.lineTo(-0.72, 0.2);
  path.lineTo(-0.42, 0.2);
  path.cubicTo(-0.22, 0.2, -0.08, 0.13, 0, 0);
  path.closeSubpath();
  return path;
}

} // namespace halfspace
