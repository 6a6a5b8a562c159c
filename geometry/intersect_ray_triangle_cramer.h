// A ray and a triangle, by Cramer's rule.
#pragma once

#include "geometry/intersect_ray_triangle.h"

namespace halfspace {

/// Where a ray meets a triangle, by determinants. With r, s, t for the corners P0, P1, P2, o and d for the
/// ray: M = [r−s | r−t | d] by columns, and r−o in place of column 1, 2, 3 for σ, τ and the ray's parameter.
template <class Scalar> struct RayTriangleCramer {
  RayTriangleCase which = RayTriangleCase::Coincident;
  FaceLocation location;
  Scalar det{};      ///< det M = d·n; 0 when parallel, and for a degenerate triangle
  Scalar detSigma{}; ///< σ = detSigma/det, which is s of the perps
  Scalar detTau{};   ///< τ = detTau/det, which is t of the perps
  Scalar detT{};     ///< the ray's t = detT/det
  Scalar sigma{};
  Scalar tau{};
  Scalar t{};

  /// Whether the ray's line crosses the triangle's plane in one point; sigma, tau, t and place are set only
  /// then.
  [[nodiscard]] bool crosses() const { return crossesPlane(which); }
};

/// Intersects a ray with a triangle by Cramer's rule (note CG). The four determinants share two cross
/// products, which are computed once. Cases as for `intersectRayTriangle`; the determinants are set in all of
/// them.
/// (1) detSigma·(r−s) + detTau·(r−t) + detT·d = det·(r−o) for any ray and triangle.
/// (2) det = d·n, with the normal n of the triangle.
/// (3) Case, place, σ, τ and t are those of `intersectRayTriangle`.
template <class Scalar>
[[nodiscard]] RayTriangleCramer<Scalar> intersectRayTriangleCramer(const Ray<Scalar> &ray,
                                                                   const Triangle<Scalar> &triangle) {
  const Scalar zero(0);
  RayTriangleCramer<Scalar> result;
  const Vec3<Scalar> toS = triangle.p0 - triangle.p1;
  const Vec3<Scalar> toT = triangle.p0 - triangle.p2;
  const Vec3<Scalar> toO = triangle.p0 - ray.origin;
  const Vec3<Scalar> throughT = cross(toT, ray.direction); // of det M and its σ
  const Vec3<Scalar> throughS = cross(toS, toO);           // of τ and t
  result.det = dot(toS, throughT);
  result.detSigma = dot(toO, throughT);
  result.detTau = dot(ray.direction, throughS);
  result.detT = -dot(toT, throughS);

  const TriangleShape shape = shapeOf(triangle);
  result.which = caseWithoutCrossing(shape, isZero(ray.direction), result.detT == zero);
  if (shape != TriangleShape::Proper || result.det == zero)
    return result;
  result.sigma = result.detSigma / result.det;
  result.tau = result.detTau / result.det;
  result.t = result.detT / result.det;
  result.location = locationInTriangle(result.sigma, result.tau);
  result.which = caseOfCrossing(result.location, result.t < zero);
  return result;
}

} // namespace halfspace
