#include "widgets/exports/label_parts.h"

#include "lessons/lesson/prose.h"

namespace halfspace {
namespace {

/// On paper a leader needs this part of its width on a screen.
constexpr double leaderPen = 0.6;

PathPart leaderPart(const Shape &shape, const LeaderShape &leader, double scale) {
  return {straightPath({leader.from * scale, leader.to * scale}, false),
          {},
          Pen{shape.color, leader.width * leaderPen * scale},
          shape.mark};
}

FormulaPart formulaPart(const Shape &shape, const LabelShape &label, double scale) {
  const LabelRoom room = roomOf(*label.formula, label.style);
  FormulaPart part;
  part.latex = label.latex;
  part.plain = plainProse(label.latex);
  part.formula = label.formula;
  part.start = (label.box.low + glm::dvec2(room.left, room.baseline)) * scale;
  part.size = label.style.pixelSize * scale;
  part.ink = label.style.ink;
  part.halo = label.style.halo;
  part.opacity = label.opacity;
  part.mark = shape.mark;
  return part;
}

} // namespace

std::vector<DrawingPart> labelParts(const std::vector<Shape> &labels, double pointsPerPixel) {
  std::vector<DrawingPart> parts;
  forEach<LeaderShape>(labels, [&](const Shape &shape, const LeaderShape &leader) {
    parts.emplace_back(leaderPart(shape, leader, pointsPerPixel));
  });
  forEach<LabelShape>(labels, [&](const Shape &shape, const LabelShape &label) {
    parts.emplace_back(formulaPart(shape, label, pointsPerPixel));
  });
  return parts;
}

} // namespace halfspace
