// A ray and a triangle, by Plücker products.
#pragma once

#include "geometry/intersect_ray_triangle.h"
#include "geometry/line.h"

namespace halfspace {

/// Where a ray meets a triangle, by the side on which its line passes each edge.
template <class Scalar> struct RayTrianglePlucker {
  RayTriangleCase which = RayTriangleCase::Coincident;
  FaceLocation location;
  std::array<Scalar, 3> products{}; ///< with the edges P1→P2, P2→P0, P0→P1: edge i is opposite corner i
  Scalar sum{};                     ///< of the products: r·n; 0 when parallel
  std::array<Scalar, 3> barycentric{}; ///< products/sum
  Scalar t{};                          ///< of the ray
  Vec3<Scalar> point{};                ///< the corners, weighted with the barycentric coordinates

  /// Whether the ray's line crosses the triangle's plane in one point; all but the products and their sum is
  /// set only then.
  [[nodiscard]] bool crosses() const { return crossesPlane(which); }
};

/// The permuted inner products of a ray's line with a triangle's edges P1→P2, P2→P0, P0→P1 (note PL): of one
/// sign where the line crosses the triangle.
/// (1) That with the edge from A to B is r·((A − Q)×(B − Q)).
/// (2) Their sum is r·n.
/// (3) All are 0 where the line lies in the plane, and of a proper triangle and r ≠ 0 only there.
/// (4) Another origin on the ray's line gives the same; k·r instead of r, k times as large ones.
template <class Scalar>
[[nodiscard]] std::array<Scalar, 3> pluckerProducts(const Ray<Scalar> &ray,
                                                    const Triangle<Scalar> &triangle) {
  const Line<Scalar> line = lineOf(ray);
  return {permutedInnerProduct(line, lineThrough(triangle.p1, triangle.p2)),
          permutedInnerProduct(line, lineThrough(triangle.p2, triangle.p0)),
          permutedInnerProduct(line, lineThrough(triangle.p0, triangle.p1))};
}

/// Intersects a ray with a triangle by Plücker products (note PL). The products see the whole line: t decides
/// between Hit and Behind. Cases as for `intersectRayTriangle`; the products and their sum are set in all of
/// them.
/// (1) The barycentric coordinates are [1 − s − tTriangle, s, tTriangle] of `intersectRayTriangle`.
/// (2) Case, place, t and point are those of `intersectRayTriangle`.
template <class Scalar>
[[nodiscard]] RayTrianglePlucker<Scalar> intersectRayTrianglePlucker(const Ray<Scalar> &ray,
                                                                     const Triangle<Scalar> &triangle) {
  const Scalar zero(0);
  RayTrianglePlucker<Scalar> result;
  result.products = pluckerProducts(ray, triangle);
  result.sum = result.products[0] + result.products[1] + result.products[2];

  const bool inPlane = result.products[0] == zero && result.products[1] == zero && result.products[2] == zero;
  const TriangleShape shape = shapeOf(triangle);
  result.which = caseWithoutCrossing(shape, isZero(ray.direction), inPlane);
  if (shape != TriangleShape::Proper || result.sum == zero)
    return result;
  for (std::size_t i = 0; i < 3; ++i)
    result.barycentric[i] = result.products[i] / result.sum;
  const auto &[first, second, third] = result.barycentric;
  result.point = triangle.p0 * first + triangle.p1 * second + triangle.p2 * third;
  result.t = dot(Vec3<Scalar>(result.point - ray.origin), ray.direction) / dot(ray.direction, ray.direction);
  result.location = locationInTriangle(second, third);
  result.which = caseOfCrossing(result.location, result.t < zero);
  return result;
}

} // namespace halfspace
