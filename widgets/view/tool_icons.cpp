#include "widgets/view/tool_icons.h"

#include "widgets/drawn_icon.h"

#include <initializer_list>

namespace halfspace {
namespace {

QPainterPath lines(std::initializer_list<QLineF> pieces) {
  QPainterPath path;
  for (const QLineF &piece : pieces) {
    path.moveTo(piece.p1());
    path.lineTo(piece.p2());
  }
  return path;
}

QPainterPath house() {
  QPainterPath path;
  path.addPolygon(QPolygonF({{2, 8.5}, {8, 2.5}, {14, 8.5}}));
  path.addPolygon(QPolygonF({{4, 7}, {4, 13.5}, {12, 13.5}, {12, 7}}));
  return path;
}

/// Two arrows that point out of a corner each.
QPainterPath outward() {
  QPainterPath path = lines({{2.5, 13.5, 7, 9}, {13.5, 2.5, 9, 7}});
  path.addPolygon(QPolygonF({{2.5, 9.5}, {2.5, 13.5}, {6.5, 13.5}}));
  path.addPolygon(QPolygonF({{9.5, 2.5}, {13.5, 2.5}, {13.5, 6.5}}));
  return path;
}

QPainterPath pathOf(ToolIcon tool) {
  switch (tool) {
  case ToolIcon::Home:
    return house();
  case ToolIcon::AlongPlane: // a plane seen as a line, and what stands on it
    return lines({{2, 13, 14, 13}, {8, 13, 8, 3}});
  case ToolIcon::Fit:
    return outward();
  case ToolIcon::Numbers:
    return lines({{6, 2.5, 5, 13.5}, {11, 2.5, 10, 13.5}, {2.5, 6, 13.5, 6}, {2.5, 10, 13.5, 10}});
  case ToolIcon::Contents:
    break;
  }
  return lines({{2.5, 4, 13.5, 4}, {2.5, 8, 13.5, 8}, {2.5, 12, 13.5, 12}});
}

} // namespace

QIcon iconOf(ToolIcon tool, const QColor &ink) { return drawnIcon(pathOf(tool), ink); }

} // namespace halfspace
