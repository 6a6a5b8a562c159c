#include "geometry/search/approach_ball.h"

#include "geometry/decide.h"
#include "geometry/filter.h"

#include <cmath>

namespace halfspace {
namespace {

/// So many radii away is near.
constexpr double nearby = 0x1p20;
/// More than how far off the nearest point of the ray is that doubles find, as a share of its distance: the
/// roundings of two dot products of three terms.
constexpr double precision = 0x1p-40;
/// Each step but the last one leaves at most this share of the way.
constexpr double leastProgress = 0x1p-20;

} // namespace

std::optional<Rational> approachBall(const Ray<Rational> &ray, const Vec3<double> &middle, double radius) {
  const Vec3<double> direction = toDouble(ray.direction);
  const double size = largestCoordinate(direction);
  const Vec3<double> unit = direction * (1 / size); // at least one long, and at most √3
  const Vec3<Rational> fromMiddle = ray.origin - exactly(middle);
  Rational t = 0;
  while (true) {
    const Vec3<double> origin = toDouble(Vec3<Rational>(fromMiddle + ray.direction * t));
    const double distance = largestCoordinate(origin);
    if (distance <= nearby * radius)
      return t;
    const double way = -dot(origin, unit) / dot(unit, unit) - 2 * (radius + distance * precision);
    if (!std::isfinite(way / size))
      return 0;
    if (way <= distance * leastProgress) // it does not come nearer
      return {};
    t += exactly(way / size);
  }
}

} // namespace halfspace
