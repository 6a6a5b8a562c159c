// A ray and a triangle, by u⊥ and v⊥ with five dot products.
#pragma once

#include "geometry/intersect_ray_plane.h"
#include "geometry/triangle.h"

namespace halfspace {

enum class RayTriangleCase { Hit, Miss, Behind, Parallel, InPlane, Coincident, Collinear, ZeroDirection };

/// The case of a ray that does not cross the triangle's plane in one point, by the first reason that holds.
[[nodiscard]] inline RayTriangleCase caseWithoutCrossing(TriangleShape shape, bool zeroDirection,
                                                         bool inPlane) {
  if (shape == TriangleShape::Coincident)
    return RayTriangleCase::Coincident;
  if (shape == TriangleShape::Collinear)
    return RayTriangleCase::Collinear;
  if (zeroDirection)
    return RayTriangleCase::ZeroDirection;
  return inPlane ? RayTriangleCase::InPlane : RayTriangleCase::Parallel;
}

/// Whether the case is one of a ray whose line crosses the triangle's plane in one point.
[[nodiscard]] inline bool crossesPlane(RayTriangleCase which) {
  return which == RayTriangleCase::Hit || which == RayTriangleCase::Miss || which == RayTriangleCase::Behind;
}

/// The case of a ray whose line crosses the triangle's plane in one point.
[[nodiscard]] inline RayTriangleCase caseOfCrossing(const FaceLocation &location, bool behind) {
  if (location.part == FacePart::Outside)
    return RayTriangleCase::Miss;
  return behind ? RayTriangleCase::Behind : RayTriangleCase::Hit;
}

/// The numbers of the method of perps that belong to the triangle alone (note PG 6.2).
template <class Scalar> struct TrianglePerps {
  Vec3<Scalar> u{};      ///< P1 − P0
  Vec3<Scalar> v{};      ///< P2 − P0
  Vec3<Scalar> normal{}; ///< u×v
  Vec3<Scalar> uPerp{};  ///< n×u = (u·u)v − (u·v)u: in the plane, perpendicular to u
  Vec3<Scalar> vPerp{};  ///< n×v = (u·v)v − (v·v)u: in the plane, perpendicular to v
  Scalar uu{};
  Scalar uv{};
  Scalar vv{};
  Scalar denominator{}; ///< (u·v)² − (u·u)(v·v) = −n·n; 0 exactly for a degenerate triangle
};

/// For any triangle.
/// (1) u⊥ = n×u and v⊥ = n×v, so that u⊥·u = v⊥·v = 0.
/// (2) u⊥·v = −v⊥·u = n·n = −denominator.
/// (3) Normal and denominator are 0 exactly for a degenerate triangle; else the denominator is negative.
template <class Scalar> [[nodiscard]] TrianglePerps<Scalar> perpsOf(const Triangle<Scalar> &triangle) {
  TrianglePerps<Scalar> result;
  result.u = triangle.p1 - triangle.p0;
  result.v = triangle.p2 - triangle.p0;
  result.normal = cross(result.u, result.v);
  result.uu = dot(result.u, result.u);
  result.uv = dot(result.u, result.v);
  result.vv = dot(result.v, result.v);
  result.uPerp = result.v * result.uu - result.u * result.uv;
  result.vPerp = result.v * result.uv - result.u * result.vv;
  result.denominator = result.uv * result.uv - result.uu * result.vv;
  return result;
}

/// Where a ray meets a triangle, with every number on the way.
template <class Scalar> struct RayTriangle {
  RayTriangleCase which = RayTriangleCase::Coincident;
  TrianglePerps<Scalar> perps;
  RayPlane<Scalar> plane; ///< the ray and the triangle's plane: t, point
  FaceLocation location;
  Vec3<Scalar> w{};   ///< point − P0
  Scalar wu{};        ///< w·u, one of the five dot products
  Scalar wv{};        ///< w·v
  Scalar s{};         ///< w = s·u + tTriangle·v
  Scalar tTriangle{}; ///< the notes call it t as well; the ray's own t is plane.t

  /// Whether the ray's line crosses the triangle's plane in one point: place, w, wu, wv, s and
  /// tTriangle are set only then.
  [[nodiscard]] bool crosses() const { return plane.crosses(); }
};

/// Intersects a ray with a triangle by the method of note PG 6.2.
/// Hit: t ≥ 0 inside or on the boundary. Miss: the line crosses the plane outside. Behind: it crosses the
/// triangle at t < 0. Parallel and InPlane as for the triangle's plane. A degenerate triangle is named by its
/// shape and only its perps are set; with a zero direction the case says so.
/// (1) The point is Q + t·r and P0 + s·u + tTriangle·v.
/// (2) The place is `locationInTriangle` of s and tTriangle. It is Outside exactly for Miss, where the line
///     crosses the plane.
/// (3) Corners in another order give the same case, t and point; the barycentric coordinates
///     [1 − s − tTriangle, s, tTriangle] go with their corners.
/// (4) k·r instead of r, k ≠ 0, divides t by k and keeps point, place, s and tTriangle. For k > 0 it keeps
///     the case as well.
template <class Scalar>
[[nodiscard]] RayTriangle<Scalar> intersectRayTriangle(const Ray<Scalar> &ray,
                                                       const Triangle<Scalar> &triangle) {
  RayTriangle<Scalar> result;
  result.perps = perpsOf(triangle);
  const auto &perps = result.perps;
  const TriangleShape shape = shapeOf(triangle);
  if (shape != TriangleShape::Proper) {
    result.which = caseWithoutCrossing(shape, isZero(ray.direction), false);
    return result;
  }
  result.plane = intersectRayPlane(ray, planeThrough(triangle.p0, perps.normal));
  if (!result.plane.crosses()) {
    result.which =
        caseWithoutCrossing(shape, isZero(ray.direction), result.plane.which == RayPlaneCase::InPlane);
    return result;
  }
  result.w = result.plane.point - triangle.p0;
  result.wu = dot(result.w, perps.u);
  result.wv = dot(result.w, perps.v);
  result.s = (perps.uv * result.wv - perps.vv * result.wu) / perps.denominator;
  result.tTriangle = (perps.uv * result.wu - perps.uu * result.wv) / perps.denominator;
  result.location = locationInTriangle(result.s, result.tTriangle);
  result.which = caseOfCrossing(result.location, result.plane.which == RayPlaneCase::Behind);
  return result;
}

} // namespace halfspace
