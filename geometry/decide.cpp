#include "geometry/decide.h"

#include "geometry/filter.h"
#include "geometry/integer.h"

#include <initializer_list>
#include <limits>
#include <optional>

namespace halfspace {

PointPlaneCase decidePointPlane(const Vec3<double> &point, const Plane<double> &plane) {
  if (isTame(plane) && isTame(point))
    if (const int side = boundedEvaluate(plane, point).sign(); side != 0 && !isZero(plane.normal))
      return side > 0 ? PointPlaneCase::Positive : PointPlaneCase::Negative;
  return measurePointPlane(exactly(point), exactly(plane)).which;
}

RayPlaneCase decideRayPlane(const Ray<double> &ray, const Plane<double> &plane) {
  if (isTame(plane) && isTame(ray)) {
    const int side = boundedEvaluate(plane, ray.origin).sign();
    const int approach = boundedDot(plane.normal, ray.direction).sign();
    if (side != 0 && approach != 0)
      return side == approach ? RayPlaneCase::Behind : RayPlaneCase::Hit;
  }
  return intersectRayPlane(exactly(ray), exactly(plane)).which;
}

namespace {

/// A ray and a triangle in integers: each coordinate divided by a power of two that they all contain.
/// Integers need no common divisors taken out, which makes this many times faster than fractions.
class WholeNumbers {
public:
  WholeNumbers(const Ray<double> &ray, const Triangle<double> &triangle)
      : m_pointExponent(lowestExponent({ray.origin, triangle.p0, triangle.p1, triangle.p2})),
        m_directionExponent(lowestExponent({ray.direction})),
        m_direction(scaled(ray.direction, m_directionExponent)) {
    const Vec3<Integer> origin = scaled(ray.origin, m_pointExponent);
    m_a = scaled(triangle.p0, m_pointExponent) - origin;
    m_b = scaled(triangle.p1, m_pointExponent) - origin;
    m_c = scaled(triangle.p2, m_pointExponent) - origin;
  }

  [[nodiscard]] TriangleProducts<Integer> products() const {
    const Vec3<Integer> bc = cross(m_b, m_c);
    const std::array<Integer, 3> products{dot(m_direction, bc), dot(m_direction, cross(m_c, m_a)),
                                          dot(m_direction, cross(m_a, m_b))};
    return {products, products[0] + products[1] + products[2], dot(m_a, bc)};
  }

  [[nodiscard]] TriangleShape shape() const { return shapeOf(Triangle<Integer>{m_a, m_b, m_c}); }
  [[nodiscard]] bool hasZeroDirection() const { return isZero(m_direction); }

  /// What t of these integers is to be multiplied with, as a power of two.
  [[nodiscard]] int tExponent() const { return m_pointExponent - m_directionExponent; }

private:
  static constexpr int digits = std::numeric_limits<double>::digits;

  /// Of the last digit that any of the coordinates has; 0 where all are 0.
  static int lowestExponent(std::initializer_list<Vec3<double>> vectors) {
    int lowest = std::numeric_limits<int>::max();
    for (const Vec3<double> &v : vectors)
      for (const double value : {v.x, v.y, v.z})
        if (value != 0)
          lowest = std::min(lowest, std::ilogb(value) + 1 - digits);
    return lowest == std::numeric_limits<int>::max() ? 0 : lowest;
  }

  static Integer scaled(double value, int exponent) {
    if (value == 0)
      return 0;
    const int own = std::ilogb(value) + 1 - digits;
    const Integer mantissa(static_cast<std::int64_t>(std::scalbn(value, -own)));
    return mantissa << (own - exponent);
  }
  static Vec3<Integer> scaled(const Vec3<double> &v, int exponent) {
    return {scaled(v.x, exponent), scaled(v.y, exponent), scaled(v.z, exponent)};
  }

  int m_pointExponent;
  int m_directionExponent;
  Vec3<Integer> m_direction;
  Vec3<Integer> m_a; // the corners as seen from the ray's origin
  Vec3<Integer> m_b;
  Vec3<Integer> m_c;
};

/// The verdict of the products' signs, for a triangle that is not degenerate and a direction that is not
/// zero.
RayTriangleVerdict verdictOf(const TriangleProducts<Integer> &exact) {
  const auto &[first, second, third] = exact.products;
  const int sum = signOf(exact.sum);
  const std::array<int, 3> signs{signOf(first) * sum, signOf(second) * sum, signOf(third) * sum};
  if (sum == 0) {
    const bool inPlane = first == 0 && second == 0 && third == 0;
    return {inPlane ? RayTriangleCase::InPlane : RayTriangleCase::Parallel, {}};
  }
  const FaceLocation location = locationBySigns(signs);
  return {caseOfCrossing(location, signOf(exact.volume) * sum < 0), location};
}

RayTriangleVerdict verdictOf(const WholeNumbers &whole, const TriangleProducts<Integer> &exact) {
  const TriangleShape shape = whole.shape();
  if (shape != TriangleShape::Proper || whole.hasZeroDirection())
    return {caseWithoutCrossing(shape, whole.hasZeroDirection(), false), {}};
  return verdictOf(exact);
}

Rational tOf(const WholeNumbers &whole, const TriangleProducts<Integer> &exact) {
  const Rational t = rationalOf(exact.volume) / rationalOf(exact.sum);
  const Rational power = rationalOf(Integer(1) << std::abs(whole.tExponent()));
  return whole.tExponent() < 0 ? t / power : t * power;
}

} // namespace

TriangleShape decideShape(const Triangle<double> &triangle) {
  if (isTame(triangle)) {
    const Vec3<double> u = triangle.p1 - triangle.p0;
    const Vec3<double> v = triangle.p2 - triangle.p0;
    const Vec3<double> normal = cross(u, v);
    const double size = 2 * largestCoordinate(u) * largestCoordinate(v); // of the two terms of a coordinate
    for (const double coordinate : {normal.x, normal.y, normal.z})
      if (Bounded::of(coordinate, size).sign() != 0)
        return TriangleShape::Proper;
  }
  return shapeOf(exactly(triangle));
}

RayTriangleVerdict decideRayTriangle(const Ray<double> &ray, const Triangle<double> &triangle) {
  if (isTame(ray) && isTame(triangle))
    if (const auto which = surelyCaseOf(filterRayTriangle(ray, triangle))) {
      const bool outside = *which == RayTriangleCase::Miss;
      return {*which, {outside ? FacePart::Outside : FacePart::Interior, -1}};
    }
  const WholeNumbers whole(ray, triangle);
  return verdictOf(whole, whole.products());
}

std::optional<Rational> exactHit(const Ray<double> &ray, const Triangle<double> &triangle) {
  const WholeNumbers whole(ray, triangle);
  const auto exact = whole.products();
  if (verdictOf(whole, exact).which != RayTriangleCase::Hit)
    return {};
  return tOf(whole, exact);
}

std::optional<Rational> exactHit(const Ray<Rational> &ray, const Triangle<double> &triangle) {
  const RayTriangle<Rational> meet = intersectRayTriangle(ray, exactly(triangle));
  if (meet.which != RayTriangleCase::Hit)
    return {};
  return meet.plane.t;
}

Rational exactT(const Ray<double> &ray, const Triangle<double> &triangle) {
  const WholeNumbers whole(ray, triangle);
  return tOf(whole, whole.products());
}

RaySphereVerdict decideRaySphere(const Ray<double> &ray, const Sphere<double> &sphere) {
  if (isTame(ray) && isTame(sphere.center) && isTame(sphere.radius) && !isZero(ray.direction)) {
    const Vec3<double> &d = ray.direction;
    const Vec3<double> m = ray.origin - sphere.center;
    const double centerSquare = dot(m, m);
    const double radiusSquare = sphere.radius * sphere.radius;
    const double outsideSize = centerSquare + radiusSquare;
    const Bounded outside = Bounded::of(centerSquare - radiusSquare, outsideSize);
    if (outside.sign() < 0)
      return {RaySphereCase::Hit, SphereContacts::Two};
    const Bounded leaving = boundedDot(d, m);
    const double leavingSize = sizeOfDot(d, m);
    const double directionSquare = dot(d, d);
    const Bounded discriminant = Bounded::of(leaving.value * leaving.value - directionSquare * outside.value,
                                             leavingSize * leavingSize + directionSquare * outsideSize);
    if (discriminant.sign() < 0)
      return {RaySphereCase::Miss, SphereContacts::None};
    if (outside.sign() > 0 && discriminant.sign() > 0 && leaving.sign() != 0)
      return {leaving.sign() > 0 ? RaySphereCase::Behind : RaySphereCase::Hit, SphereContacts::Two};
  }
  const RaySphere<Rational> meet = intersectRaySphere(exactly(ray), exactly(sphere));
  return {meet.which, meet.contacts};
}

Vec3<Rational> exactly(const Vec3<double> &vector) {
  return {exactly(vector.x), exactly(vector.y), exactly(vector.z)};
}

Ray<Rational> exactly(const Ray<double> &ray) { return {exactly(ray.origin), exactly(ray.direction)}; }

Plane<Rational> exactly(const Plane<double> &plane) { return {exactly(plane.normal), exactly(plane.offset)}; }

Triangle<Rational> exactly(const Triangle<double> &triangle) {
  return {exactly(triangle.p0), exactly(triangle.p1), exactly(triangle.p2)};
}

Sphere<Rational> exactly(const Sphere<double> &sphere) {
  return {exactly(sphere.center), exactly(sphere.radius)};
}

} // namespace halfspace
