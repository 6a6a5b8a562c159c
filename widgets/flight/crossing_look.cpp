#include "widgets/flight/crossing_look.h"

#include "lessons/term/plain_text.h"

#include <QCoreApplication>
#include <QPainter>

namespace halfspace {
namespace {

/// How much of the muted ink is left of what lies behind the start.
constexpr double ghostStrength = 0.72;
/// Radii of marks, in that of a hit.
constexpr double nearestRadius = 1.1;
constexpr double hollowRadius = 0.85;
constexpr double diamondRadius = 0.8;
constexpr double strokeWidth = 0.32;

QString translated(const char *words) { return QCoreApplication::translate("CrossingLook", words); }

Standing standingOf(RayTriangleCase which) {
  switch (which) {
  case RayTriangleCase::Hit:
    return Standing::Hit;
  case RayTriangleCase::Miss:
    return Standing::Outside;
  case RayTriangleCase::Behind:
    return Standing::Behind;
  case RayTriangleCase::Parallel:
    return Standing::Parallel;
  case RayTriangleCase::InPlane:
    return Standing::InPlane;
  case RayTriangleCase::ZeroDirection:
    return Standing::NoDirection;
  case RayTriangleCase::Coincident:
  case RayTriangleCase::Collinear:
    break;
  }
  return Standing::NoTriangle;
}

Standing standingAmongAll(const Crossing &crossing, const Crossings &crossings) {
  if (crossing.number == crossings.nearest)
    return Standing::First;
  const Crossing *nearest = nearestOf(crossings);
  const bool isTied = nearest && crossing.which == RayTriangleCase::Hit && crossing.at->t == nearest->at->t;
  return isTied ? Standing::FirstToo : standingOf(crossing.which);
}

bool areBeingAsked(const Crossings &crossings) {
  return crossings.nearestSoFar && crossings.chosen < crossings.fragments;
}

} // namespace

Standing standingOf(const Crossing &crossing, const Crossings &crossings) {
  if (!areBeingAsked(crossings))
    return standingAmongAll(crossing, crossings);
  if (crossing.number > crossings.chosen)
    return Standing::NotAsked;
  return crossing.number == crossings.nearestSoFar ? Standing::FirstSoFar : standingOf(crossing.which);
}

bool isBehindStart(const Crossing &crossing) { return crossing.at && crossing.at->t.sign() < 0; }

QString wordsOf(Standing standing) {
  switch (standing) {
  case Standing::First:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "hit first"));
  case Standing::FirstToo:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "hit first, too"));
  case Standing::FirstSoFar:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "nearest so far"));
  case Standing::Hit:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "hit"));
  case Standing::Outside:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "outside"));
  case Standing::Behind:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "behind the start"));
  case Standing::Parallel:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "parallel"));
  case Standing::InPlane:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "in the plane"));
  case Standing::NoTriangle:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "no triangle"));
  case Standing::NoDirection:
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "no direction"));
  case Standing::NotAsked:
    break;
  }
  return QStringLiteral("…");
}

QString shortWordsOf(Standing standing) {
  if (standing == Standing::FirstSoFar)
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "nearest"));
  return standing == Standing::Behind ? translated(QT_TRANSLATE_NOOP("CrossingLook", "behind"))
                                      : wordsOf(standing);
}

QString sentenceOf(const Crossing &crossing, Standing standing) {
  const QString name = QString::fromStdString(crossing.name);
  if (standing == Standing::NotAsked)
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "%1: not asked yet")).arg(name);
  if (!crossing.at)
    return translated(QT_TRANSLATE_NOOP("CrossingLook", "%1: %2")).arg(name, wordsOf(standing));
  return translated(QT_TRANSLATE_NOOP("CrossingLook", "%1: λ%2, %3"))
      .arg(name, QString::fromStdString(relatedText(written(crossing.at->t))), wordsOf(standing));
}

Color inkOf(Standing standing, bool isBehindStart, const Theme &theme) {
  if (isNearest(standing))
    return theme.inkOf(Subject::Ray);
  if (isHit(standing))
    return theme.ink;
  return isBehindStart ? mix(theme.panel, theme.mutedInk, ghostStrength) : theme.mutedInk;
}

void paintMark(QPainter &painter, QPointF center, double radius, Standing standing, const QColor &ink) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(ink, strokeWidth * radius));
  painter.setBrush(Qt::NoBrush);
  if (standing == Standing::Behind) {
    painter.drawEllipse(center, hollowRadius * radius, hollowRadius * radius);
  } else if (standing == Standing::Outside) {
    const double reach = diamondRadius * radius;
    painter.drawPolygon(QPolygonF({center - QPointF(0, reach), center + QPointF(reach, 0),
                                   center + QPointF(0, reach), center - QPointF(reach, 0)}));
  } else if (isHit(standing)) {
    const double reach = ringRadius * radius - strokeWidth * radius / 2;
    if (isNearest(standing))
      painter.drawEllipse(center, reach, reach);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    const double disc = isNearest(standing) ? nearestRadius * radius : radius;
    painter.drawEllipse(center, disc, disc);
  }
  painter.restore();
}

} // namespace halfspace
