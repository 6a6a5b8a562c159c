// Points that slide in a plane. No two directions of a plane can follow its normal everywhere without a jump,
// so a point of it is told by a place: it is the foot of that place, wherever the plane turns.
#include "lessons/object/bound_point.h"
#include "lessons/object/flat.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

enum Coordinates : std::uint8_t { Near };

std::optional<ExactVec3> placeOf(const Object &bound, const Object &host) {
  const PlaneObject plane = objectAs<PlaneObject>(host).value();
  if (isZero(plane.normal))
    return {};
  return Flat::plane(plane.point, plane.normal).nearest(bound[Near]);
}

Object nearest(Object bound, const Object &host, const ExactVec3 &place) {
  Object moved = bound;
  moved[Near] = place;
  const auto foot = placeOf(moved, host);
  if (foot)
    bound[Near] = *foot;
  return bound;
}

/// The coordinate in which the normal is longest: there the plane is told best by the two others.
int steepestAxis(const ExactVec3 &normal) {
  int steepest = 2;
  for (int axis = 0; axis < 2; ++axis)
    if (abs(normal[axis]) > abs(normal[steepest]))
      steepest = axis;
  return steepest;
}

/// Two coordinates on the grid, the third so that the place lies in the plane.
Object onGrid(Object bound, const Object &host, const Rational &step) {
  const PlaneObject plane = objectAs<PlaneObject>(host).value();
  if (isZero(plane.normal))
    return bound;
  const int steepest = steepestAxis(plane.normal);
  for (int axis = 0; axis < 3; ++axis)
    if (axis != steepest)
      bound[Near][axis] = roundToMultiple(bound[Near][axis], step);
  bound[Near][steepest] -= dot(plane.normal, bound[Near] - plane.point) / plane.normal[steepest];
  return bound;
}

void guide(const Object &host, Handle &handle) { handle.normal = objectAs<PlaneObject>(host)->normal; }

} // namespace

namespace object_kinds {

Kind point_on_plane() {
  return boundPoint(
      "point-on-plane", [] { return words("a point on a plane"); },
      "a point that slides in a plane: the foot of a place", {{"near", CoordinateRole::Position}},
      settleNothing,
      {.host = PlaneObject::kind, .placeOf = placeOf, .nearest = nearest, .onGrid = onGrid, .guide = guide});
}

} // namespace object_kinds
} // namespace halfspace
