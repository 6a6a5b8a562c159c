// Points of a triangle's plane, outside the triangle too.
#include "lessons/object/point_by_sides.h"
#include "lessons/words.h"

#include <utility>

namespace halfspace {
namespace {

/// In what is left of the plane where the corners lie on one line: along the first side that leads somewhere.
Object nearestOnLine(Object bound, const Object &host, const ExactVec3 &place) {
  const auto [u, v] = TriangleSides(host);
  const ExactVec3 &side = isZero(u) ? v : u;
  bound[S].x = 0;
  bound[T].x = 0;
  if (!isZero(side))
    bound[isZero(u) ? T : S].x = dot(place - host[0], side) / dot(side, side);
  return bound;
}

Object nearest(Object bound, const Object &host, const ExactVec3 &place) {
  const auto foot = footBySides(bound, host, place);
  return foot ? *foot : nearestOnLine(std::move(bound), host, place);
}

} // namespace

namespace object_kinds {

Kind point_on_triangle_plane() {
  return pointBySides(
      "point-on-triangle-plane", [] { return words("a point of a triangle's plane"); },
      "a point of a triangle's plane, outside it too: P0 + s(P1 − P0) + t(P2 − P0)", settleNothing, nearest);
}

} // namespace object_kinds
} // namespace halfspace
