// A point and a plane: side, signed distance, foot.
#pragma once

#include "geometry/plane.h"

namespace halfspace {

enum class PointPlaneCase { Positive, Negative, On, ZeroNormal };

/// What a point and a plane have to do with each other, with every number on the way.
template <class Scalar> struct PointPlane {
  PointPlaneCase which = PointPlaneCase::ZeroNormal;
  Scalar f{};                    ///< n·Q + d; a distance only when |n| = 1
  Scalar normalSquared{};        ///< n·n
  Root<Scalar> signedDistance{}; ///< f/|n|, positive on the side that n points to
  Scalar footParameter{};        ///< f/(n·n): Q − footParameter·n is the foot
  Vec3<Scalar> foot{};           ///< the nearest point of the plane
};

/// Side, signed distance and foot of a point (notes PG 3.4 and 3.5).
/// With a zero normal the case says so, and only f and normalSquared are set. Else:
/// (1) The foot lies on the plane, and Q − foot is a multiple of n.
/// (2) |signedDistance| = |Q − foot|, and its sign is that of f: it is 0, and Q its own foot, exactly for On.
/// (3) |Q − X|² = |Q − foot|² + |foot − X|² for each point X of the plane: none is nearer.
/// (4) k·[n, d] instead of [n, d], k ≠ 0: f is k times as large, the foot stays, and so does the distance but
///     for its sign, which changes for k < 0.
template <class Scalar>
[[nodiscard]] PointPlane<Scalar> measurePointPlane(const Vec3<Scalar> &point, const Plane<Scalar> &plane) {
  PointPlane<Scalar> result;
  result.f = evaluate(plane, point);
  result.normalSquared = dot(plane.normal, plane.normal);
  if (isZero(plane.normal))
    return result;
  const Scalar zero(0);
  result.which = result.f > zero   ? PointPlaneCase::Positive
                 : result.f < zero ? PointPlaneCase::Negative
                                   : PointPlaneCase::On;
  result.signedDistance = overRoot(result.f, result.normalSquared);
  result.footParameter = result.f / result.normalSquared;
  result.foot = point - plane.normal * result.footParameter;
  return result;
}

} // namespace halfspace
