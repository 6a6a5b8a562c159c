// Signs of double expressions that can be trusted.
#pragma once

#include "geometry/intersect_ray_triangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace halfspace {

/// A bound on the relative error of the expressions below: each is a sum of products in which every term goes
/// through at most 12 roundings of 2^-53 (differences of coordinates, products, sums), measured against the
/// sum of the terms' magnitudes. The rest of 2^-48 is room for the roundings of the bound itself.
inline constexpr double filterError = 0x1p-48;

/// A bound on what underflow adds to that: each product is at most 2^-1075 off then, and may be multiplied
/// with two more tame numbers.
inline constexpr double underflowError = 0x1p-600;

/// A double and how far the true value may be from it.
/// (1) |true value − value| ≤ error for all that this file makes of tame numbers, and for the difference and
///     the quotient of such.
struct Bounded {
  double value = 0;
  double error = 0;

  /// `size` is the sum of the terms' magnitudes, or more.
  [[nodiscard]] static Bounded of(double value, double size) {
    return {value, filterError * size + underflowError};
  }

  /// −1 or 1 where the true value surely has this sign; 0 where that is open.
  /// (2) So a sign ≠ 0 is the true one.
  [[nodiscard]] int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }

  [[nodiscard]] Bounded operator-(const Bounded &other) const {
    const double difference = value - other.value;
    return {difference, error + other.error + filterError * std::abs(difference)};
  }
  /// Requires a divisor whose sign is certain.
  [[nodiscard]] Bounded operator/(const Bounded &divisor) const {
    const double quotient = value / divisor.value;
    return {quotient,
            (error + std::abs(quotient) * divisor.error) / (std::abs(divisor.value) - divisor.error) +
                filterError * std::abs(quotient) + underflowError};
  }
};

[[nodiscard]] inline double largestCoordinate(const Vec3<double> &v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Whether numbers are so small that a product of four differences of them is finite: the bounds hold only
/// then.
[[nodiscard]] inline bool isTame(double value) { return std::abs(value) <= 0x1p200; }
[[nodiscard]] inline bool isTame(const Vec3<double> &v) { return isTame(largestCoordinate(v)); }
[[nodiscard]] inline bool isTame(const Ray<double> &ray) {
  return isTame(ray.origin) && isTame(ray.direction);
}
[[nodiscard]] inline bool isTame(const Plane<double> &plane) {
  return isTame(plane.normal) && isTame(plane.offset);
}
[[nodiscard]] inline bool isTame(const Triangle<double> &triangle) {
  return isTame(triangle.p0) && isTame(triangle.p1) && isTame(triangle.p2);
}

/// |n1·x1| + |n2·x2| + |n3·x3|
[[nodiscard]] inline double sizeOfDot(const Vec3<double> &n, const Vec3<double> &x) {
  return std::abs(n.x * x.x) + std::abs(n.y * x.y) + std::abs(n.z * x.z);
}

/// n·x with a bound. Requires tame numbers.
[[nodiscard]] inline Bounded boundedDot(const Vec3<double> &n, const Vec3<double> &x) {
  return Bounded::of(dot(n, x), sizeOfDot(n, x));
}

/// f(x) = n·x + d with a bound. Requires tame numbers.
[[nodiscard]] inline Bounded boundedEvaluate(const Plane<double> &plane, const Vec3<double> &x) {
  const Bounded product = boundedDot(plane.normal, x);
  return {product.value + plane.offset, product.error + filterError * std::abs(plane.offset)};
}

/// What a ray and a triangle tell without a division.
template <class Value> struct TriangleProducts {
  std::array<Value, 3> products; ///< of note PL, with the edges opposite the corners
  Value sum;                     ///< of the products: r·n
  Value volume;                  ///< six times that of the ray's origin and the triangle; t = volume/sum
};

/// What plain arithmetic can tell of a ray and a triangle.
struct FilteredTriangle {
  /// The line crosses the triangle's plane, outside. The products are not set then.
  bool surelyMissed = false;
  TriangleProducts<Bounded> bounded{};
};

/// Computed from the triangle's first corner, like Cramer's determinants: seen from the ray's origin a small
/// triangle far away would be lost in the rounding. Requires a tame ray and a tame triangle.
/// (1) surelyMissed only where `intersectRayTriangle` of the exact numbers is a Miss.
/// (2) Else, within their bounds, the products and their sum are those of `intersectRayTrianglePlucker`, and
///     the volume is detT of `intersectRayTriangleCramer`.
[[nodiscard]] inline FilteredTriangle filterRayTriangle(const Ray<double> &ray,
                                                        const Triangle<double> &triangle) {
  const Vec3<double> u = triangle.p1 - triangle.p0;
  const Vec3<double> v = triangle.p2 - triangle.p0;
  const Vec3<double> w = ray.origin - triangle.p0;
  const double sizeU = largestCoordinate(u);
  const double sizeV = largestCoordinate(v);
  const double sizeW = largestCoordinate(w);
  const double sizeR = largestCoordinate(ray.direction);
  constexpr double terms = 6; // of a volume of three edges

  const Vec3<double> acrossV = cross(v, ray.direction);
  const Bounded sum = Bounded::of(dot(u, acrossV), terms * sizeU * sizeV * sizeR);
  const Bounded second = Bounded::of(dot(w, acrossV), terms * sizeW * sizeV * sizeR);
  const int facing = sum.sign();
  const auto isOutside = [facing](const Bounded &product) {
    return facing != 0 && product.sign() == -facing;
  };
  if (isOutside(second) || isOutside(sum - second))
    return {true};
  const Vec3<double> acrossU = cross(u, w);
  const Bounded third = Bounded::of(dot(ray.direction, acrossU), terms * sizeR * sizeU * sizeW);
  const Bounded first = sum - second - third;
  if (isOutside(third) || isOutside(first))
    return {true};
  return {false, {{first, second, third}, sum, Bounded::of(dot(v, acrossU), terms * sizeV * sizeU * sizeW)}};
}

/// The case that plain arithmetic is sure of, if it is. A Hit and a case Behind are inside the triangle.
/// (1) It is that of `intersectRayTriangle` of the exact numbers.
[[nodiscard]] inline std::optional<RayTriangleCase> surelyCaseOf(const FilteredTriangle &filtered) {
  if (filtered.surelyMissed)
    return RayTriangleCase::Miss;
  const auto &[first, second, third] = filtered.bounded.products;
  const int sign = first.sign();
  const int volume = filtered.bounded.volume.sign();
  if (sign == 0 || second.sign() != sign || third.sign() != sign || volume == 0)
    return {};
  return sign == volume ? RayTriangleCase::Hit : RayTriangleCase::Behind;
}

} // namespace halfspace
