#include "geometry/weighted_point.h"

#include "geometry/integer.h"

#include <cmath>

namespace halfspace {

WeightedPoint<Rational> weighted(const Vec3<Rational> &point) {
  if (point.x.isInteger() && point.y.isInteger() && point.z.isInteger())
    return {point, 1};
  const Rational weight =
      rationalOf(mp::lcm(mp::lcm(denominatorOf(point.x), denominatorOf(point.y)), denominatorOf(point.z)));
  return {point * weight, weight};
}

WeightedPoint<Rational> rounded(const WeightedPoint<Rational> &point) {
  Vec3<double> nearest;
  for (glm::length_t axis = 0; axis < 3; ++axis)
    nearest[axis] = nearestDouble(integerOf(point.position[axis]), integerOf(point.weight));
  if (!std::isfinite(nearest.x) || !std::isfinite(nearest.y) || !std::isfinite(nearest.z))
    return point;
  return weighted(Vec3<Rational>(exactly(nearest.x), exactly(nearest.y), exactly(nearest.z)));
}

} // namespace halfspace
