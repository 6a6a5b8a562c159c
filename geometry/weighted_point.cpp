#include "geometry/weighted_point.h"

#include <cmath>

namespace halfspace {

WeightedPoint<Rational> weighted(const Vec3<Rational> &point) {
  if (point.x.isInteger() && point.y.isInteger() && point.z.isInteger())
    return {point, 1};
  const Rational weight(
      Integer(mp::lcm(mp::lcm(point.x.denominator(), point.y.denominator()), point.z.denominator())));
  return {point * weight, weight};
}

WeightedPoint<Rational> rounded(const WeightedPoint<Rational> &point) {
  Vec3<double> nearest;
  for (glm::length_t axis = 0; axis < 3; ++axis)
    nearest[axis] = nearestDouble(point.position[axis].numerator(), point.weight.numerator());
  if (!std::isfinite(nearest.x) || !std::isfinite(nearest.y) || !std::isfinite(nearest.z))
    return point;
  return weighted(Vec3<Rational>(exactly(nearest.x), exactly(nearest.y), exactly(nearest.z)));
}

} // namespace halfspace
