// Points of a triangle, its edges included: P0 + s u + t v with u = P1 − P0, v = P2 − P0.
#include "lessons/object/point_by_sides.h"
#include "lessons/object/triangle.h"

#include <glm/vec2.hpp>

#include <algorithm>

namespace halfspace {
namespace {

/// Within the triangle: 0 ≤ s, 0 ≤ t, s + t ≤ 1.
void settle(Object &bound) {
  bound[StepsOfU].x = std::clamp(bound[StepsOfU].x, Rational(0), Rational(1));
  bound[StepsOfV].x = std::clamp(bound[StepsOfV].x, Rational(0), Rational(1 - bound[StepsOfU].x));
}

bool isWithin(const Object &bound) {
  return bound[StepsOfU].x >= 0 && bound[StepsOfV].x >= 0 && bound[StepsOfU].x + bound[StepsOfV].x <= 1;
}

/// With these s and t.
Object withSteps(Object bound, const Rational &s, const Rational &t) {
  bound[StepsOfU].x = s;
  bound[StepsOfV].x = t;
  return bound;
}

/// On the edge between two corners, which have these s and t, the nearest to a place.
Object nearestOnEdge(const Object &bound, const Object &host, const ExactVec3 &place, glm::ivec2 from,
                     glm::ivec2 to) {
  const auto corner = [&](glm::ivec2 at) { return *placeBySides(withSteps(bound, at.x, at.y), host); };
  const ExactVec3 edge = corner(to) - corner(from);
  const Rational square = dot(edge, edge);
  const Rational along =
      square == 0 ? Rational(0)
                  : std::clamp(Rational(dot(place - corner(from), edge) / square), Rational(0), Rational(1));
  return withSteps(bound, from.x + along * (to.x - from.x), from.y + along * (to.y - from.y));
}

Object nearest(Object bound, const Object &host, const ExactVec3 &place) {
  if (const auto inPlane = nearestBySides(bound, host, place); inPlane && isWithin(*inPlane))
    return *inPlane;
  const auto squaredDistance = [&](const Object &at) {
    const ExactVec3 way = *placeBySides(at, host) - place;
    return dot(way, way);
  };
  const Object edges[] = {nearestOnEdge(bound, host, place, {0, 0}, {1, 0}),
                          nearestOnEdge(bound, host, place, {0, 0}, {0, 1}),
                          nearestOnEdge(bound, host, place, {1, 0}, {0, 1})};
  return *std::min_element(std::begin(edges), std::end(edges), [&](const Object &a, const Object &b) {
    return squaredDistance(a) < squaredDistance(b);
  });
}

} // namespace

namespace object_kinds {

Kind point_on_triangle() {
  return boundPoint("point-on-triangle", "a point of a triangle: P0 + s(P1 − P0) + t(P2 − P0)", sideSteps(),
                    settle,
                    {.host = TriangleObject::kind,
                     .placeOf = placeBySides,
                     .nearest = nearest,
                     .onGrid = bySidesOnGrid,
                     .guide = guideBySides});
}

} // namespace object_kinds
} // namespace halfspace
