// Points of the plane of a triangle, also outside of it: P0 + s u + t v with any s and t.
#include "lessons/object/point_by_sides.h"
#include "lessons/object/triangle.h"

namespace halfspace {
namespace {

Object nearest(Object bound, const Object &host, const ExactVec3 &place) {
  return nearestBySides(bound, host, place).value_or(bound);
}

} // namespace

namespace object_kinds {

Kind point_on_triangle_plane() {
  return boundPoint("point-on-triangle-plane",
                    "a point of a triangle's plane, also outside of it: P0 + s(P1 − P0) + t(P2 − P0)",
                    sideSteps(), settleNothing,
                    {.host = TriangleObject::kind,
                     .placeOf = placeBySides,
                     .nearest = nearest,
                     .onGrid = bySidesOnGrid,
                     .guide = guideBySides});
}

} // namespace object_kinds
} // namespace halfspace
