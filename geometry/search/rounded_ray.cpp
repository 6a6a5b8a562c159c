#include "geometry/search/rounded_ray.h"

#include "geometry/decide.h"
#include "geometry/filter.h"

#include <cmath>

namespace halfspace {
namespace {

bool isFinite(const Ray<double> &ray) {
  return std::isfinite(largestCoordinate(ray.origin)) && std::isfinite(largestCoordinate(ray.direction));
}

bool areSame(const Ray<Rational> &one, const Ray<Rational> &other) {
  return one.origin == other.origin && one.direction == other.direction;
}

} // namespace

RoundedRay::RoundedRay(const Ray<Rational> &given)
    : exact(given), rounded{toDouble(given.origin), toDouble(given.direction)},
      isExact(isFinite(rounded) && areSame(exactly(rounded), exact)) {}

} // namespace halfspace
