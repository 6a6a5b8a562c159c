// A ray and a plane.
#pragma once

#include "geometry/plane.h"
#include "geometry/ray.h"

#include <cassert>

namespace halfspace {

enum class RayPlaneCase { Hit, Behind, Parallel, InPlane, ZeroNormal, ZeroDirection };

/// Where a ray meets a plane, with every number on the way.
template <class Scalar> struct RayPlane {
  RayPlaneCase which = RayPlaneCase::ZeroNormal;
  Scalar numerator{};   ///< (P − Q)·n, which is −f(Q)
  Scalar denominator{}; ///< r·n
  Scalar t{};           ///< numerator/denominator; a distance only when |r| = 1
  Vec3<Scalar> point{}; ///< Q + t·r

  /// Whether the ray's line crosses the plane in one point; t and point are set only then.
  [[nodiscard]] bool crosses() const { return which == RayPlaneCase::Hit || which == RayPlaneCase::Behind; }
};

/// Intersects a ray with a plane by dot products (note PG 5).
/// Hit: t ≥ 0. Behind: t < 0. Parallel: the denominator is 0. InPlane: the numerator is 0 too.
/// With a zero normal, else a zero direction, the case says so.
/// (1) It crosses exactly where the denominator is not 0.
/// (2) The point lies on the plane: f(Q + t·r) = 0.
/// (3) k·r instead of r, k ≠ 0, divides t by k: the point stays.
/// (4) k·[n, d] instead of [n, d], k ≠ 0, multiplies numerator and denominator by k and changes nothing else.
template <class Scalar>
[[nodiscard]] RayPlane<Scalar> intersectRayPlane(const Ray<Scalar> &ray, const Plane<Scalar> &plane) {
  const Scalar zero(0);
  RayPlane<Scalar> result;
  result.numerator = -evaluate(plane, ray.origin);
  result.denominator = dot(ray.direction, plane.normal);
  if (isZero(plane.normal))
    return result;
  if (isZero(ray.direction)) {
    result.which = RayPlaneCase::ZeroDirection;
    return result;
  }
  if (result.denominator == zero) {
    result.which = result.numerator == zero ? RayPlaneCase::InPlane : RayPlaneCase::Parallel;
    return result;
  }
  result.t = result.numerator / result.denominator;
  result.which = result.t < zero ? RayPlaneCase::Behind : RayPlaneCase::Hit;
  result.point = pointAt(ray, result.t);
  return result;
}

/// The unit normal of a plane on the side that a ray's line comes from: n·r < 0 (note RP 28, which forgets to
/// turn it). Requires a direction that is not parallel to the plane.
/// (1) It is n/|n| or −n/|n|, so that its length is 1.
/// (2) Its product with the direction is negative.
/// (3) The same for k·n, k ≠ 0, and for a positive multiple of the direction; the negative for −direction.
template <class Scalar>
[[nodiscard]] std::array<Root<Scalar>, 3> facingNormal(const Vec3<Scalar> &normal,
                                                       const Vec3<Scalar> &direction) {
  assert(dot(normal, direction) != Scalar(0));
  const Scalar square = dot(normal, normal);
  const Vec3<Scalar> facing = dot(normal, direction) > Scalar(0) ? Vec3<Scalar>(-normal) : normal;
  return {overRoot(facing.x, square), overRoot(facing.y, square), overRoot(facing.z, square)};
}

} // namespace halfspace
