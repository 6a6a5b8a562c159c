#include "widgets/picture/shapes/gizmo_shape.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

using Part = Gizmo::Part;

constexpr std::array allParts{Part::AxisX,   Part::AxisY,   Part::AxisZ,
                              Part::PlaneXY, Part::PlaneYZ, Part::PlaneZX};

constexpr Place unitX{1, 0, 0};
constexpr Place unitY{0, 1, 0};
constexpr Place unitZ{0, 0, 1};

/// Makes the outlines of parts, moved out by so many design pixels, each of which is `unit` long.
struct Outlines {
  Place at;
  double moved;
  double unit;

  [[nodiscard]] std::vector<Place> arrow(Place axis) const {
    const double start = (gizmoArrowStart + moved) * unit;
    return {at + axis * start, at + axis * (start + gizmoArrowLength * unit)};
  }
  [[nodiscard]] std::vector<Place> square(Place first, Place second) const {
    const double near = (gizmoSquareNear + moved) * unit;
    const double far = near + gizmoSquareSide * unit;
    return {at + first * near + second * near, at + first * far + second * near,
            at + first * far + second * far, at + first * near + second * far};
  }
  [[nodiscard]] std::vector<Place> of(Part part) const {
    switch (part) {
    case Part::AxisX:
      return arrow(unitX);
    case Part::AxisY:
      return arrow(unitY);
    case Part::AxisZ:
      return arrow(unitZ);
    case Part::PlaneXY:
      return square(unitX, unitY);
    case Part::PlaneYZ:
      return square(unitY, unitZ);
    case Part::PlaneZX:
      return square(unitZ, unitX);
    }
    return {};
  }
};

/// Whether an outline on the screen keeps its gap from all strokes.
bool isClear(const std::vector<glm::dvec3> &outline, const std::vector<Stroke> &strokes, double pixelRatio) {
  constexpr int piecesOfSide = 8; // of some pixels each, less than what they must keep clear of measures
  for (std::size_t i = 0; i < outline.size(); ++i)
    for (int piece = 0; piece < piecesOfSide; ++piece) {
      const glm::dvec3 pixel =
          glm::mix(outline[i], outline[(i + 1) % outline.size()], double(piece) / piecesOfSide);
      if (std::any_of(strokes.begin(), strokes.end(), [&](const Stroke &stroke) {
            return distanceTo(stroke, glm::dvec2(pixel)) < gizmoGap * pixelRatio;
          }))
        return false;
    }
  return true;
}

/// The outline of a part, as little moved out as leaves it clear of what the gizmo keeps clear of.
std::optional<std::vector<Place>> clearOutline(Part part, const Gizmo &gizmo, const Camera &camera,
                                               PixelSize size, double pixelRatio) {
  const double unit = camera.unitsPerPixel(gizmo.at, size) * pixelRatio;
  for (double moved = 0; moved <= gizmoFarthestMove; moved += gizmoMoveStep) {
    std::vector<Place> outline = Outlines{gizmo.at, moved, unit}.of(part);
    const auto projected = projectAll(camera, size, outline);
    if (!projected || isClear(*projected, gizmo.clearOf, pixelRatio))
      return outline;
  }
  return {};
}

} // namespace

DragConstraint constraintOf(Part part) {
  switch (part) {
  case Part::AxisX:
    return alongLine(unitX);
  case Part::AxisY:
    return alongLine(unitY);
  case Part::AxisZ:
    return alongLine(unitZ);
  case Part::PlaneXY:
    return inPlane(unitZ);
  case Part::PlaneYZ:
    return inPlane(unitX);
  case Part::PlaneZX:
    break;
  }
  return inPlane(unitY);
}

std::vector<GizmoPartShape> gizmoParts(const Gizmo &gizmo, const Camera &camera, PixelSize size,
                                       double pixelRatio) {
  std::vector<GizmoPartShape> shapes;
  if (!gizmo.axes || camera.unitsPerPixel(gizmo.at, size) <= 0)
    return shapes;
  for (const Part part : allParts)
    if (isGrabbable(constraintOf(part), camera, gizmo.at))
      if (auto outline = clearOutline(part, gizmo, camera, size, pixelRatio))
        shapes.push_back({part, std::move(*outline)});
  return shapes;
}

std::vector<Place> knobDirections(const Knob &knob, const Camera &camera) {
  if (!knob.axis)
    return {camera.right(), camera.up()};
  return *knob.axis == Place(0) ? std::vector<Place>() : std::vector{glm::normalize(*knob.axis)};
}

std::optional<Part> gizmoPartAt(const Gizmo &gizmo, const Camera &camera, PixelSize size, double pixelRatio,
                                glm::dvec2 pixel) {
  std::optional<Part> nearest;
  double nearestDistance = gizmoPickDistance * pixelRatio;
  for (const GizmoPartShape &shape : gizmoParts(gizmo, camera, size, pixelRatio)) {
    const auto projected = projectAll(camera, size, shape.outline);
    if (!projected)
      continue;
    std::vector<glm::dvec2> outline(projected->begin(), projected->end());
    if (shape.isSquare()) {
      if (isInside(pixel, outline))
        return shape.part;
    } else if (const double distance = distanceToSegment(pixel, outline[0], outline[1]);
               distance <= nearestDistance) {
      nearest = shape.part;
      nearestDistance = distance;
    }
  }
  return nearest;
}

} // namespace halfspace
