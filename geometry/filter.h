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

  [[nodiscard]] Bounded operator-(const Bounded &other) const {
    const double difference = value - other.value;
    return {difference, error + other.error + filterError * std::abs(difference)};
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

/// What a ray and a triangle tell without a division.
template <class Value> struct TriangleProducts {
  std::array<Value, 3> products; ///< of note PL, with the edges opposite the corners
  Value sum;                     ///< of the products: r·n
  Value volume;                  ///< six times that of the ray's origin and the triangle; t = volume/sum
};

/// For a tame ray and a tame triangle. Computed from the triangle's first corner, like Cramer's determinants:
/// seen from the ray's origin a small triangle far away would be lost in the rounding.
[[nodiscard]] inline TriangleProducts<Bounded> boundedProducts(const Ray<double> &ray,
                                                               const Triangle<double> &triangle) {
  const Vec3<double> u = triangle.p1 - triangle.p0;
  const Vec3<double> v = triangle.p2 - triangle.p0;
  const Vec3<double> w = ray.origin - triangle.p0;
  const Vec3<double> normal = cross(u, v);
  const double sizeU = largestCoordinate(u);
  const double sizeV = largestCoordinate(v);
  const double sizeW = largestCoordinate(w);
  const double sizeR = largestCoordinate(ray.direction);
  // A volume of three edges is a sum of six products.
  constexpr double unit = 6 * filterError;
  const Bounded sum{dot(ray.direction, normal), unit * sizeR * sizeU * sizeV};
  const Bounded second{dot(w, cross(v, ray.direction)), unit * sizeW * sizeV * sizeR};
  const Bounded third{dot(ray.direction, cross(u, w)), unit * sizeR * sizeU * sizeW};
  return {{sum - second - third, second, third}, sum, {-dot(w, normal), unit * sizeW * sizeU * sizeV}};
}

} // namespace halfspace
