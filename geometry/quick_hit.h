// Whether and where a ray hits a triangle, and nothing else: for testing millions.
#pragma once

#include "geometry/intersect_ray_triangle.h"

namespace halfspace {

/// The method of the perps (note PG 6.2) with all that belongs to the triangle put into three linear forms:
/// its plane, and the two that give s and t of a point of that plane. For testing one triangle against many
/// rays.
template <class Scalar> struct PreparedTriangle {
  Plane<Scalar> plane;
  Plane<Scalar> s; ///< s(x) = vPerp·(x − P0)/(u·vPerp)
  Plane<Scalar> t; ///< t(x) = uPerp·(x − P0)/(v·uPerp)
};

/// Requires a triangle that is not degenerate.
/// (1) plane, s and t are 0, 0, 0 at P0; 0, 1, 0 at P1; and 0, 0, 1 at P2.
/// (2) plane is `planeThrough` the corners.
template <class Scalar> [[nodiscard]] PreparedTriangle<Scalar> prepare(const Triangle<Scalar> &triangle) {
  const TrianglePerps<Scalar> perps = perpsOf(triangle);
  const auto form = [&](const Vec3<Scalar> &perp, const Vec3<Scalar> &along) {
    const Scalar scale = Scalar(1) / dot(along, perp);
    return planeThrough(triangle.p0, Vec3<Scalar>(perp * scale));
  };
  return {planeThrough(triangle.p0, perps.normal), form(perps.vPerp, perps.u), form(perps.uPerp, perps.v)};
}

/// A hit by its parameters alone.
template <class Scalar> struct QuickHit {
  bool hit = false; ///< t ≥ 0, and inside or on the boundary; the rest is set only then
  Scalar t{};       ///< of the ray
  Scalar s{};       ///< the point is P0 + s·u + tTriangle·v
  Scalar tTriangle{};
};

/// The hits of `intersectRayTriangle`, and nothing else; over doubles subject to rounding.
/// (1) Over fractions hit is true exactly where that is a Hit, with its t, s and tTriangle.
template <class Scalar>
[[nodiscard]] QuickHit<Scalar> quickHit(const Ray<Scalar> &ray, const PreparedTriangle<Scalar> &triangle) {
  const Scalar zero(0);
  const Scalar approach = dot(ray.direction, triangle.plane.normal);
  if (approach == zero)
    return {};
  const Scalar t = -evaluate(triangle.plane, ray.origin) / approach;
  if (!(t >= zero)) // and so below: over doubles something may be no number
    return {};
  const Vec3<Scalar> point = pointAt(ray, t);
  const Scalar s = evaluate(triangle.s, point);
  const Scalar tTriangle = evaluate(triangle.t, point);
  if (!(s >= zero && tTriangle >= zero && s + tTriangle <= Scalar(1)))
    return {};
  return {true, t, s, tTriangle};
}

/// The same, law (1) too, with any triangle, of which nothing is kept, by Cramer's rule (note CG; see
/// `intersectRayTriangleCramer`).
template <class Scalar>
[[nodiscard]] QuickHit<Scalar> quickHit(const Ray<Scalar> &ray, const Triangle<Scalar> &triangle) {
  const Scalar zero(0);
  const Scalar one(1);
  const Vec3<Scalar> toS = triangle.p0 - triangle.p1;
  const Vec3<Scalar> toT = triangle.p0 - triangle.p2;
  const Vec3<Scalar> throughT = cross(toT, ray.direction);
  const Scalar det = dot(toS, throughT);
  if (det == zero)
    return {};
  const Scalar share = one / det;
  const Vec3<Scalar> toO = triangle.p0 - ray.origin;
  const Scalar s = dot(toO, throughT) * share;
  if (!(s >= zero && s <= one))
    return {};
  const Vec3<Scalar> throughS = cross(toS, toO);
  const Scalar tTriangle = dot(ray.direction, throughS) * share;
  if (!(tTriangle >= zero && s + tTriangle <= one))
    return {};
  const Scalar t = -dot(toT, throughS) * share;
  if (!(t >= zero))
    return {};
  return {true, t, s, tTriangle};
}

} // namespace halfspace
