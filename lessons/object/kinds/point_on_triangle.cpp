// Points of a triangle, its edges included.
#include "lessons/object/point_by_sides.h"
#include "lessons/words.h"

#include <glm/vec2.hpp>

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// Within the triangle: 0 ≤ s, 0 ≤ t, s + t ≤ 1.
void settle(Object &bound) {
  bound[S].x = std::clamp(bound[S].x, Rational(0), Rational(1));
  bound[T].x = std::clamp(bound[T].x, Rational(0), Rational(1 - bound[S].x));
}

bool isWithin(const Object &bound) {
  return bound[S].x >= 0 && bound[T].x >= 0 && bound[S].x + bound[T].x <= 1;
}

/// On the edge between two corners, which have these s and t, the nearest to a place.
Object nearestOnEdge(Object bound, const Object &host, const ExactVec3 &place, glm::ivec2 from,
                     glm::ivec2 to) {
  const auto [u, v] = TriangleSides(host);
  const ExactVec3 start = host[0] + u * Rational(from.x) + v * Rational(from.y);
  const ExactVec3 edge = u * Rational(to.x - from.x) + v * Rational(to.y - from.y);
  const Rational square = dot(edge, edge);
  const Rational along =
      square == 0 ? Rational(0)
                  : std::clamp(Rational(dot(place - start, edge) / square), Rational(0), Rational(1));
  bound[S].x = from.x + along * (to.x - from.x);
  bound[T].x = from.y + along * (to.y - from.y);
  return bound;
}

Object nearest(Object bound, const Object &host, const ExactVec3 &place) {
  if (auto foot = footBySides(bound, host, place); foot && isWithin(*foot))
    return *foot;
  const auto squaredDistance = [&](const Object &at) {
    const ExactVec3 way = *placeBySides(at, host) - place;
    return dot(way, way);
  };
  const Object edges[] = {nearestOnEdge(bound, host, place, {0, 0}, {1, 0}),
                          nearestOnEdge(bound, host, place, {0, 0}, {0, 1}),
                          nearestOnEdge(std::move(bound), host, place, {1, 0}, {0, 1})};
  return *std::min_element(std::begin(edges), std::end(edges), [&](const Object &a, const Object &b) {
    return squaredDistance(a) < squaredDistance(b);
  });
}

} // namespace

namespace object_kinds {

Kind point_on_triangle() {
  return pointBySides(
      "point-on-triangle", [] { return words("a point of a triangle"); },
      "a point of a triangle: P0 + s(P1 − P0) + t(P2 − P0)", settle, nearest);
}

} // namespace object_kinds
} // namespace halfspace
