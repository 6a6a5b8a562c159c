// A segment and a plane.
#pragma once

#include "geometry/plane.h"

namespace halfspace {

/// Crosses: between the ends. Touches: with one end. Beside: both ends are on one side, and the line of the
/// segment meets the plane elsewhere.
enum class SegmentPlaneCase { Crosses, Touches, Beside, Parallel, InPlane, ZeroLength, ZeroNormal };

/// Where a segment from one end to the other meets a plane.
template <class Scalar> struct SegmentPlane {
  SegmentPlaneCase which = SegmentPlaneCase::ZeroNormal;
  Scalar atFrom{};      ///< what f comes to at the first end: n·from + d
  Scalar atTo{};        ///< and at the second one
  Scalar t{};           ///< the part of the way at which the segment's line meets the plane
  Vec3<Scalar> point{}; ///< from + t·(to − from); like t set for Crosses, Touches and Beside
};

/// Intersects a segment with a plane by what f comes to at its ends, between which it changes evenly. With a
/// zero normal, else with both ends at one point, the case says so; what f comes to is set in all of them.
/// (1) The point lies in the plane. It is an end exactly for Touches.
/// (2) 0 < t < 1 for Crosses, t = 0 or t = 1 for Touches, and t < 0 or t > 1 for Beside.
/// (3) From the other end the case and the point are the same, and t is 1 − t.
/// (4) k·[n, d], k ≠ 0, makes what f comes to k times as large and changes nothing else.
template <class Scalar>
[[nodiscard]] SegmentPlane<Scalar> intersectSegmentPlane(const Vec3<Scalar> &from, const Vec3<Scalar> &to,
                                                         const Plane<Scalar> &plane) {
  const Scalar zero(0);
  SegmentPlane<Scalar> result;
  result.atFrom = evaluate(plane, from);
  result.atTo = evaluate(plane, to);
  if (isZero(plane.normal))
    return result;
  if (from == to) {
    result.which = SegmentPlaneCase::ZeroLength;
    return result;
  }
  if (result.atFrom == result.atTo) {
    result.which = result.atFrom == zero ? SegmentPlaneCase::InPlane : SegmentPlaneCase::Parallel;
    return result;
  }
  result.t = result.atFrom / (result.atFrom - result.atTo);
  result.point = from + (to - from) * result.t;
  if (result.atFrom == zero || result.atTo == zero)
    result.which = SegmentPlaneCase::Touches;
  else
    result.which =
        (result.atFrom > zero) == (result.atTo > zero) ? SegmentPlaneCase::Beside : SegmentPlaneCase::Crosses;
  return result;
}

} // namespace halfspace
