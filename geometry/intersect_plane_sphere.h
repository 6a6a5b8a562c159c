// A plane and a sphere.
#pragma once

#include "geometry/point_plane.h"
#include "geometry/sphere.h"

namespace halfspace {

/// GreatCircle: a circle around the center of the sphere. Tangent: one point. Miss: none.
enum class PlaneSphereCase { Circle, GreatCircle, Tangent, Miss, ZeroNormal };

/// Where a plane meets a sphere, with every number on the way.
template <class Scalar> struct PlaneSphere {
  PlaneSphereCase which = PlaneSphereCase::ZeroNormal;
  PointPlane<Scalar> center{};  ///< that of the sphere and the plane; its foot is the center of the circle
  Scalar circleRadiusSquared{}; ///< radius² − distance²; negative for Miss
  Root<Scalar> circleRadius{};  ///< 0 for Tangent and Miss
};

/// Intersects a plane with a sphere. With a zero normal the case says so, and nothing else is set but what
/// `measurePointPlane` sets then. Requires a radius > 0.
/// (1) The center of the circle, the foot of the sphere's center, lies in the plane.
/// (2) circleRadiusSquared is negative, 0 or positive exactly for Miss, for Tangent and for both circles, of
///     which GreatCircle has radius².
/// (3) A point X of the plane lies on the sphere exactly where |X − foot|² = circleRadiusSquared.
/// (4) k·[n, d] instead of [n, d], k ≠ 0: the same case and the same circle.
template <class Scalar>
[[nodiscard]] PlaneSphere<Scalar> intersectPlaneSphere(const Plane<Scalar> &plane,
                                                       const Sphere<Scalar> &sphere) {
  const Scalar zero(0);
  PlaneSphere<Scalar> result;
  result.center = measurePointPlane(sphere.center, plane);
  if (result.center.which == PointPlaneCase::ZeroNormal)
    return result;
  const Scalar distanceSquared = result.center.f * result.center.f / result.center.normalSquared;
  result.circleRadiusSquared = sphere.radius * sphere.radius - distanceSquared;
  if (result.circleRadiusSquared < zero) {
    result.which = PlaneSphereCase::Miss;
    return result;
  }
  result.circleRadius = timesRoot(Scalar(1), result.circleRadiusSquared);
  result.which = result.circleRadiusSquared == zero          ? PlaneSphereCase::Tangent
                 : result.center.which == PointPlaneCase::On ? PlaneSphereCase::GreatCircle
                                                             : PlaneSphereCase::Circle;
  return result;
}

} // namespace halfspace
