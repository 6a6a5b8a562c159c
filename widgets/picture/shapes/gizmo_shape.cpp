#include "widgets/picture/shapes/gizmo_shape.h"

#include "widgets/picture/screen_shapes.h"

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

std::vector<Place> arrowOutline(Place at, Place axis, double unit) {
  return {at + axis * (gizmoArrowStart * unit), at + axis * (gizmoArrowEnd * unit)};
}

std::vector<Place> squareOutline(Place at, Place first, Place second, double unit) {
  const double near = gizmoSquareNear * unit;
  const double far = gizmoSquareFar * unit;
  return {at + first * near + second * near, at + first * far + second * near,
          at + first * far + second * far, at + first * near + second * far};
}

std::vector<Place> outlineOf(Part part, Place at, double unit) {
  switch (part) {
  case Part::AxisX:
    return arrowOutline(at, unitX, unit);
  case Part::AxisY:
    return arrowOutline(at, unitY, unit);
  case Part::AxisZ:
    return arrowOutline(at, unitZ, unit);
  case Part::PlaneXY:
    return squareOutline(at, unitX, unitY, unit);
  case Part::PlaneYZ:
    return squareOutline(at, unitY, unitZ, unit);
  case Part::PlaneZX:
    return squareOutline(at, unitZ, unitX, unit);
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
  const double unit = camera.unitsPerPixel(gizmo.at, size) * pixelRatio;
  if (!gizmo.axes || unit <= 0)
    return shapes;
  for (const Part part : allParts)
    if (isGrabbable(constraintOf(part), camera, gizmo.at))
      shapes.push_back({part, outlineOf(part, gizmo.at, unit)});
  return shapes;
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
