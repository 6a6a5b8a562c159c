#include "widgets/drawn_icon.h"

#include <QPainter>

namespace halfspace {
namespace {

constexpr double penWidth = 1.4;
constexpr int sizes[] = {16, 24, 32, 48, 64, 96};

} // namespace

QIcon drawnIcon(const QPainterPath &strokes, const QColor &ink, const QPainterPath &filled) {
  QIcon icon;
  for (const int size : sizes) {
    QPixmap pixmap(size, size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(size / iconSquare, size / iconSquare);
    painter.fillPath(filled, ink);
    painter.setPen(QPen(ink, penWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(strokes);
    icon.addPixmap(pixmap);
  }
  return icon;
}

} // namespace halfspace
