// Points in whole numbers.
#pragma once

#include "geometry/line.h"
#include "geometry/plane.h"

#include <initializer_list>
#include <vector>

namespace halfspace {

/// The point position/weight, with weight > 0 (homogeneous coordinates).
///
/// Over fractions position and weight are whole numbers, so what is computed of them needs no common divisors
/// taken out: for long numbers that is nearly all the work that fractions are. Planes and lines of such
/// points are those of the points themselves times a positive number, which no sign feels.
template <class Scalar> struct WeightedPoint {
  Vec3<Scalar> position;
  Scalar weight;

  /// Of points as `weighted` writes them, equal ones are written in the same way.
  [[nodiscard]] bool operator==(const WeightedPoint &) const = default;
};

/// Over fractions the weight is the least common denominator of the coordinates; of no more than one point:
/// that of many points would be as long as all their denominators together.
/// (1) position = weight·point.
/// (2) Over fractions position and weight are whole numbers whose greatest common divisor is 1.
[[nodiscard]] WeightedPoint<Rational> weighted(const Vec3<Rational> &point);
template <class Scalar> [[nodiscard]] WeightedPoint<Scalar> weighted(const Vec3<Scalar> &point) {
  return {point, Scalar(1)};
}

template <class Scalar>
[[nodiscard]] std::vector<WeightedPoint<Scalar>> weighted(const std::vector<Vec3<Scalar>> &points) {
  std::vector<WeightedPoint<Scalar>> result;
  result.reserve(points.size());
  for (const Vec3<Scalar> &point : points)
    result.push_back(weighted(point));
  return result;
}

/// A positive multiple of the plane through three points.
/// (1) It is that of the points themselves times the product of the weights; so it is zero exactly where they
///     lie on one line.
template <class Scalar>
[[nodiscard]] Plane<Scalar> planeThrough(const WeightedPoint<Scalar> &p0, const WeightedPoint<Scalar> &p1,
                                         const WeightedPoint<Scalar> &p2) {
  // (p1 − p0)×(p2 − p0) = p0×p1 + p1×p2 + p2×p0
  const Vec3<Scalar> p01 = cross(p0.position, p1.position);
  const Vec3<Scalar> p12 = cross(p1.position, p2.position);
  const Vec3<Scalar> p20 = cross(p2.position, p0.position);
  return {p01 * p2.weight + p12 * p0.weight + p20 * p1.weight, Scalar(-dot(p01, p2.position))};
}

/// A positive multiple of the line from p to q.
/// (1) It is that of the points themselves times the product of the weights.
template <class Scalar>
[[nodiscard]] Line<Scalar> lineThrough(const WeightedPoint<Scalar> &p, const WeightedPoint<Scalar> &q) {
  return {q.position * p.weight - p.position * q.weight, cross(p.position, q.position)};
}

/// A positive multiple of f(x) = n·x + d.
/// (1) It is that of the point itself times its weight.
template <class Scalar>
[[nodiscard]] Scalar evaluate(const Plane<Scalar> &plane, const WeightedPoint<Scalar> &x) {
  return dot(plane.normal, x.position) + plane.offset * x.weight;
}

/// The mean of some points. Requires at least one.
/// (1) position/weight is the sum of the points divided by their number.
template <class Scalar>
[[nodiscard]] WeightedPoint<Scalar> meanOf(std::initializer_list<WeightedPoint<Scalar>> points) {
  WeightedPoint<Scalar> mean{{}, Scalar(1)};
  for (const WeightedPoint<Scalar> &point : points)
    mean = {mean.position * point.weight + point.position * mean.weight, mean.weight * point.weight};
  mean.weight *= Scalar(static_cast<int>(points.size()));
  return mean;
}

/// A point nearby with few digits, each coordinate the nearest double; the point itself beyond their range.
[[nodiscard]] WeightedPoint<Rational> rounded(const WeightedPoint<Rational> &point);
template <class Scalar> [[nodiscard]] WeightedPoint<Scalar> rounded(const WeightedPoint<Scalar> &point) {
  return point;
}

} // namespace halfspace
