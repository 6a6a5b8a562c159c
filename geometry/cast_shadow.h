// Where the light that passes a point meets a plane: parallel light, as of the sun, and that of a lamp.
#pragma once

#include "geometry/intersect_ray_plane.h"

namespace halfspace {

/// Falls: the light comes to the point first, or to both at once, and the point throws a shadow. PlaneFirst:
/// it meets the plane before the point. Away: it leads away from the plane. Parallel: it runs along the
/// plane, beside it or in it. NoLight: no ray of light leads to the point. NoPlane: the normal is zero.
enum class ShadowCase { Falls, PlaneFirst, Away, Parallel, NoLight, NoPlane };

/// The light that passes a point, and the plane.
template <class Scalar> struct Shadow {
  ShadowCase which = ShadowCase::NoPlane;
  Scalar t{};           ///< steps from where the light is counted from: the point, or the lamp
  Vec3<Scalar> place{}; ///< where the line of the light meets the plane

  /// Whether the line of the light meets the plane in one point; t and the place are set only then.
  [[nodiscard]] bool crosses() const {
    return which == ShadowCase::Falls || which == ShadowCase::PlaneFirst || which == ShadowCase::Away;
  }
  [[nodiscard]] bool falls() const { return which == ShadowCase::Falls; }
};

namespace detail {

/// What is found of the line of the light; `which` where it meets the plane in one point.
template <class Scalar>
[[nodiscard]] Shadow<Scalar> shadowOf(const RayPlane<Scalar> &meet, ShadowCase which) {
  switch (meet.which) {
  case RayPlaneCase::ZeroNormal:
    return {ShadowCase::NoPlane};
  case RayPlaneCase::ZeroDirection:
    return {ShadowCase::NoLight};
  case RayPlaneCase::Parallel:
  case RayPlaneCase::InPlane:
    return {ShadowCase::Parallel};
  case RayPlaneCase::Hit:
  case RayPlaneCase::Behind:
    break;
  }
  return {which, meet.t, meet.point};
}

} // namespace detail

/// The shadow of a point by parallel light: point + t·direction. It falls where t ≥ 0; else the plane comes
/// first. With a zero direction there is no light.
/// (1) The place lies in the plane, and the way to it along the direction.
/// (2) It is affine: the shadow of (1 − s)·A + s·B is (1 − s)·A′ + s·B′, with t in the same proportion.
/// (3) A positive multiple of the direction leads to the same place, and a multiple ≠ 0 of [n, d] changes
///     nothing.
template <class Scalar>
[[nodiscard]] Shadow<Scalar> castBySun(const Vec3<Scalar> &point, const Vec3<Scalar> &direction,
                                       const Plane<Scalar> &plane) {
  const auto meet = intersectRayPlane(Ray<Scalar>{point, direction}, plane);
  return detail::shadowOf(meet, meet.which == RayPlaneCase::Hit ? ShadowCase::Falls : ShadowCase::PlaneFirst);
}

/// The shadow of a point by a lamp: lamp + t·(point − lamp). It falls where t ≥ 1; the plane comes first for
/// 0 ≤ t < 1, and the ray leads away from it for t < 0. At the lamp itself there is no ray.
/// (1) The place lies in the plane, and on the line of lamp and point.
/// (2) 1/t is affine where the lamp is not in the plane: that of (1 − s)·A + s·B is (1 − s)/t(A) + s/t(B). So
///     the shadow of the midpoint of A and B is the part t(A)/(t(A) + t(B)) of the way from A′ to B′.
/// (3) A multiple ≠ 0 of [n, d] changes nothing.
template <class Scalar>
[[nodiscard]] Shadow<Scalar> castByLamp(const Vec3<Scalar> &point, const Vec3<Scalar> &lamp,
                                        const Plane<Scalar> &plane) {
  const auto meet = intersectRayPlane(Ray<Scalar>{lamp, Vec3<Scalar>(point - lamp)}, plane);
  return detail::shadowOf(meet, meet.t >= Scalar(1)  ? ShadowCase::Falls
                                : meet.t < Scalar(0) ? ShadowCase::Away
                                                     : ShadowCase::PlaneFirst);
}

} // namespace halfspace
