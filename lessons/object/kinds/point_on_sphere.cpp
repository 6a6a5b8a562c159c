// Points of a sphere's surface, by the stereographic projection from its lowest point: c + R (2s, 2t,
// 1 − s² − t²) / (1 + s² + t²). So fractions s and t give a point of fractions that lies on it exactly; each
// is reached but the lowest, to which it comes as near as one likes. s = t = 0 is the highest.
#include "lessons/object/bound_point.h"
#include "lessons/object/drawing.h"
#include "lessons/words.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

enum Freedoms : std::uint8_t { S, T };
enum Host : std::uint8_t { Center, Radius };

/// Nearer to the lowest point nobody can see the difference.
const Rational farthestFreedom = 1000;
/// A place that is not on the sphere is brought there to this fineness of s and t: far below what is seen.
const Rational fineness(1, 1000000);

void settle(Object &bound) {
  for (const Freedoms freedom : {S, T})
    bound[freedom].x = std::clamp(bound[freedom].x, Rational(-farthestFreedom), farthestFreedom);
}

std::optional<ExactVec3> placeOf(const Object &bound, const Object &host) {
  const Rational &s = bound[S].x;
  const Rational &t = bound[T].x;
  const Rational square = s * s + t * t;
  const ExactVec3 direction{2 * s, 2 * t, 1 - square};
  return host[Center] + direction * Rational(host[Radius].x / (1 + square));
}

/// The same for a place that lies on the sphere and is not its lowest point.
Object exactly(Object bound, const ExactVec3 &way, const Rational &radius) {
  bound[S].x = way.x / (radius + way.z);
  bound[T].x = way.y / (radius + way.z);
  return bound;
}

Object nearest(Object bound, const Object &host, const ExactVec3 &place) {
  const ExactVec3 way = place - host[Center];
  const Rational &radius = host[Radius].x;
  if (isZero(way) || radius == 0)
    return bound;
  if (dot(way, way) == radius * radius && way.z != -radius)
    return exactly(std::move(bound), way, radius);
  const Place direction = unitOf(way);
  const glm::dvec2 level(direction);
  const double length = glm::length(level);
  const glm::dvec2 heading = length == 0 ? glm::dvec2(1, 0) : level / length;
  const double away = std::min(std::sqrt(std::max(0.0, 1 - direction.z) / std::max(0.0, 1 + direction.z)),
                               toDouble(farthestFreedom));
  bound[S].x = roundToMultiple(heading.x * away, fineness);
  bound[T].x = roundToMultiple(heading.y * away, fineness);
  return bound;
}

Object onGrid(Object bound, const Object &host, const Rational &step) {
  const Rational &radius = host[Radius].x;
  const Rational coarse = freedomStep(step, 4 * radius * radius);
  for (const Freedoms freedom : {S, T})
    bound[freedom].x = roundToMultiple(bound[freedom].x, coarse);
  return bound;
}

void guide(const Object &host, Handle &handle) {
  if (host[Radius].x != 0)
    handle.center = host[Center];
}

} // namespace

namespace object_kinds {

Kind point_on_sphere() {
  return boundPoint(
      "point-on-sphere", [] { return words("a point of a sphere"); },
      "a point of a sphere: c + R(2s, 2t, 1 − s² − t²)/(1 + s² + t²)",
      {{"s", CoordinateRole::Number}, {"t", CoordinateRole::Number}}, settle,
      {.host = "sphere", .placeOf = placeOf, .nearest = nearest, .onGrid = onGrid, .guide = guide});
}

} // namespace object_kinds
} // namespace halfspace
