// Two planes, by Plücker coordinates.
#pragma once

#include "geometry/angle.h"
#include "geometry/line.h"
#include "geometry/plane.h"

namespace halfspace {

enum class PlanePlaneCase { Line, Parallel, Coincident, ZeroNormal };

/// What two planes have in common.
template <class Scalar> struct PlanePlane {
  PlanePlaneCase which = PlanePlaneCase::ZeroNormal;
  Root<Scalar> cosine{};   ///< of the angle between the normals
  Line<Scalar> line{};     ///< {n1×n2 : d1·n2 − d2·n1}; set only for Line
  Vec3<Scalar> nearest{};  ///< the line's point nearest to the origin; set only for Line
  Root<Scalar> distance{}; ///< 0 where they meet
};

/// Intersects two planes (note PL). The line's direction is n1×n2. Coincident planes may have normals of
/// different lengths and directions. With a zero normal the case says so, and nothing else is set.
/// (1) The line is real and lies in both planes.
/// (2) intersectPlanes(b, a) has the negative line and is the same else.
/// (3) k·[n, d] instead of one of them, k ≠ 0, makes the line's numbers k times as large, turns the sign of
///     the cosine for k < 0, and changes nothing else.
/// (4) The cosine is 1 or −1 exactly for Parallel and Coincident.
/// (5) The distance is that of each point of one plane from the other for Parallel, and 0 for the others.
template <class Scalar>
[[nodiscard]] PlanePlane<Scalar> intersectPlanes(const Plane<Scalar> &a, const Plane<Scalar> &b) {
  PlanePlane<Scalar> result;
  if (isZero(a.normal) || isZero(b.normal))
    return result;
  result.cosine = cosineBetween(a.normal, b.normal);
  const Vec3<Scalar> direction = cross(a.normal, b.normal);
  const Vec3<Scalar> moment = b.normal * a.offset - a.normal * b.offset;
  if (isZero(direction)) {
    result.which = isZero(moment) ? PlanePlaneCase::Coincident : PlanePlaneCase::Parallel;
    // n2 = k·n1 makes the moment (k·d1 − d2)·n1, and the distance is |d1 − d2/k|/|n1|.
    result.distance = timesRoot(
        Scalar(1), Scalar(dot(moment, moment) / (dot(a.normal, a.normal) * dot(b.normal, b.normal))));
    return result;
  }
  result.which = PlanePlaneCase::Line;
  result.line = {direction, moment};
  result.nearest = nearestToOrigin(result.line);
  return result;
}

} // namespace halfspace
