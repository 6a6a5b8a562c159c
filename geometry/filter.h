// Signs of double expressions that can be trusted.
#pragma once

#include "geometry/ray.h"
#include "geometry/triangle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace halfspace {

/// A bound on the relative error of the expressions below: each is a sum of products in which every term goes
/// through at most 12 roundings of 2^-53 (differences of coordinates, products, sums), measured against the
/// sum of the terms' magnitudes. The rest of 2^-48 is room for the roundings of the bound itself.
inline constexpr double filterError = 0x1p-48;

/// A double and how far the true value may be from it.
struct Bounded {
  double value = 0;
  double error = 0;

  /// −1 or 1 where the true value surely has this sign; 0 where that is open.
  [[nodiscard]] int sign() const { return value > error ? 1 : value < -error ? -1 : 0; }

  [[nodiscard]] Bounded operator+(const Bounded &other) const {
    const double sum = value + other.value;
    return {sum, error + other.error + filterError * std::abs(sum)};
  }
  /// For a divisor whose sign is certain.
  [[nodiscard]] Bounded operator/(const Bounded &divisor) const {
    const double quotient = value / divisor.value;
    return {quotient,
            (error + std::abs(quotient) * divisor.error) / (std::abs(divisor.value) - divisor.error) +
                filterError * std::abs(quotient)};
  }
};

/// Whether no product of four differences of such numbers leaves the range in which doubles keep their
/// relative precision: the bounds hold only then.
[[nodiscard]] inline bool isTame(double value) {
  const double size = std::abs(value);
  return value == 0 || (0x1p-200 <= size && size <= 0x1p200);
}
[[nodiscard]] inline bool isTame(const Vec3<double> &v) { return isTame(v.x) && isTame(v.y) && isTame(v.z); }
[[nodiscard]] inline bool isTame(const Ray<double> &ray) {
  return isTame(ray.origin) && isTame(ray.direction);
}
[[nodiscard]] inline bool isTame(const Triangle<double> &triangle) {
  return isTame(triangle.p0) && isTame(triangle.p1) && isTame(triangle.p2);
}

[[nodiscard]] inline double largestCoordinate(const Vec3<double> &v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// What a ray and a triangle tell without a division: the products of note PL with the edges opposite the
/// corners, and six times the signed volume of the ray's origin and the triangle. The sum of the products is
/// r·n, and the ray's t is volume/sum.
template <class Value> struct TriangleProducts {
  std::array<Value, 3> products;
  Value volume;
};

/// For a tame ray and a tame triangle.
[[nodiscard]] inline TriangleProducts<Bounded> boundedProducts(const Ray<double> &ray,
                                                               const Triangle<double> &triangle) {
  const Vec3<double> a = triangle.p0 - ray.origin;
  const Vec3<double> b = triangle.p1 - ray.origin;
  const Vec3<double> c = triangle.p2 - ray.origin;
  const Vec3<double> bc = cross(b, c);
  const double sizeA = largestCoordinate(a);
  const double sizeB = largestCoordinate(b);
  const double sizeC = largestCoordinate(c);
  // A volume of three edges is a sum of six products.
  const double unit = 6 * filterError;
  const double alongRay = unit * largestCoordinate(ray.direction);
  return {{Bounded{dot(ray.direction, bc), alongRay * sizeB * sizeC},
           Bounded{dot(ray.direction, cross(c, a)), alongRay * sizeC * sizeA},
           Bounded{dot(ray.direction, cross(a, b)), alongRay * sizeA * sizeB}},
          {dot(a, bc), unit * sizeA * sizeB * sizeC}};
}

} // namespace halfspace
