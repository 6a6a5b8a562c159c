#include "widgets/verdict.h"

#include "widgets/colors.h"

#include <QPainter>

namespace halfspace {

void paintVerdict(QPainter &painter, QPointF center, double radius, Verdict verdict, const Theme &theme,
                  bool isOfNow) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (verdict == Verdict::Open) {
    painter.setPen(QPen(toQColor(theme.mutedInk), 1.4));
    painter.drawEllipse(center, radius, radius);
  } else {
    const bool right = verdict == Verdict::Right;
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQColor(!isOfNow ? theme.mutedInk
                              : right  ? theme.inkOf(Subject::Triangle)
                                       : theme.warning));
    painter.drawEllipse(center, radius, radius);
    const auto at = [&](double x, double y) { return center + QPointF(x, y) * radius; };
    painter.setPen(QPen(toQColor(theme.panel), 0.24 * radius, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (right) {
      painter.drawLine(at(-0.45, 0.02), at(-0.12, 0.38));
      painter.drawLine(at(-0.12, 0.38), at(0.46, -0.34));
    } else {
      painter.drawLine(at(-0.36, -0.36), at(0.36, 0.36));
      painter.drawLine(at(-0.36, 0.36), at(0.36, -0.36));
    }
  }
  painter.restore();
}

} // namespace halfspace
