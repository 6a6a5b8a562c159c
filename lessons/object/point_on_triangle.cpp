// Points of a triangle, its edges included: P0 + s u + t v with u = P1 − P0, v = P2 − P0.
#include "lessons/object/bound_point.h"
#include "lessons/object/triangle.h"

#include <glm/vec2.hpp>

#include <algorithm>

namespace halfspace {
namespace {

enum Coordinates : std::uint8_t { S, T };

/// Within the triangle: 0 ≤ s, 0 ≤ t, s + t ≤ 1.
void settle(Object &bound) {
  bound[S].x = std::clamp(bound[S].x, Rational(0), Rational(1));
  bound[T].x = std::clamp(bound[T].x, Rational(0), Rational(1 - bound[S].x));
}

struct Sides {
  explicit Sides(const Object &triangle) : u(triangle[1] - triangle[0]), v(triangle[2] - triangle[0]) {}
  ExactVec3 u;
  ExactVec3 v;
};

std::optional<ExactVec3> placeOf(const Object &bound, const Object &host) {
  const Sides sides(host);
  return host[0] + sides.u * bound[S].x + sides.v * bound[T].x;
}

bool isWithin(const Object &bound) {
  return bound[S].x >= 0 && bound[T].x >= 0 && bound[S].x + bound[T].x <= 1;
}

/// On the edge between two corners, which have these s and t, the nearest to a place.
Object nearestOnEdge(Object bound, const Object &host, const ExactVec3 &place, glm::ivec2 from,
                     glm::ivec2 to) {
  const Sides sides(host);
  const auto corner = [&](glm::ivec2 at) {
    return host[0] + sides.u * Rational(at.x) + sides.v * Rational(at.y);
  };
  const ExactVec3 edge = corner(to) - corner(from);
  const Rational square = dot(edge, edge);
  const Rational along =
      square == 0 ? Rational(0)
                  : std::clamp(Rational(dot(place - corner(from), edge) / square), Rational(0), Rational(1));
  bound[S].x = from.x + along * (to.x - from.x);
  bound[T].x = from.y + along * (to.y - from.y);
  return bound;
}

Object nearest(Object bound, const Object &host, const ExactVec3 &place) {
  const auto [u, v] = Sides(host);
  const ExactVec3 w = place - host[0];
  const Rational determinant = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
  if (determinant != 0) {
    bound[S].x = (dot(w, u) * dot(v, v) - dot(w, v) * dot(u, v)) / determinant;
    bound[T].x = (dot(w, v) * dot(u, u) - dot(w, u) * dot(u, v)) / determinant;
    if (isWithin(bound))
      return bound;
  }
  const auto squaredDistance = [&](const Object &at) {
    const ExactVec3 way = *placeOf(at, host) - place;
    return dot(way, way);
  };
  const Object edges[] = {nearestOnEdge(bound, host, place, {0, 0}, {1, 0}),
                          nearestOnEdge(bound, host, place, {0, 0}, {0, 1}),
                          nearestOnEdge(bound, host, place, {1, 0}, {0, 1})};
  return *std::min_element(std::begin(edges), std::end(edges), [&](const Object &a, const Object &b) {
    return squaredDistance(a) < squaredDistance(b);
  });
}

Object onGrid(Object bound, const Object &host, const Rational &step) {
  const auto [u, v] = Sides(host);
  const Rational coarse = freedomStep(step, std::max(dot(u, u), dot(v, v)));
  bound[S].x = roundToMultiple(bound[S].x, coarse);
  bound[T].x = roundToMultiple(bound[T].x, coarse);
  return bound;
}

void guide(const Object &host, Handle &handle) {
  handle.normal = normalOfCorners(host);
  if (handle.normal == ExactVec3(0)) // no more than a line
    handle.axis = isZero(host[1] - host[0]) ? host[2] - host[0] : host[1] - host[0];
}

} // namespace

namespace object_kinds {

Kind point_on_triangle() {
  return boundPoint("point-on-triangle", "a point of a triangle: P0 + s(P1 − P0) + t(P2 − P0)",
                    {{"s", CoordinateRole::Number}, {"t", CoordinateRole::Number}}, settle,
                    {.host = TriangleObject::kind,
                     .placeOf = placeOf,
                     .nearest = nearest,
                     .onGrid = onGrid,
                     .guide = guide});
}

} // namespace object_kinds
} // namespace halfspace
