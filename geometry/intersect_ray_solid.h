// A ray and a convex solid, by Plücker products.
#pragma once

#include "geometry/intersect_ray_plane.h"
#include "geometry/location.h"
#include "geometry/solid.h"

namespace halfspace {

enum class RaySolidCase { Hit, Behind, Miss, ZeroDirection };
/// What the whole line has in common with the solid: One: it touches it in a point. Along: it lies in a face
/// or an edge. Two: it goes through.
enum class SolidContacts { None, One, Two, Along };

/// A point where a ray's line goes into or comes out of a solid.
template <class Scalar> struct SolidCrossing {
  Scalar t{};
  Vec3<Scalar> point{};
  std::size_t face = 0; ///< the lowest index of the faces there that the line goes into, or comes out of
};

/// Where a ray meets a convex solid.
template <class Scalar> struct RaySolid {
  RaySolidCase which = RaySolidCase::ZeroDirection;
  SolidContacts contacts = SolidContacts::None;
  SolidLocation origin = SolidLocation::Outside; ///< where the ray starts
  std::optional<SolidCrossing<Scalar>> entered;  ///< both are there, unless the case is Miss or ZeroDirection
  std::optional<SolidCrossing<Scalar>> left;
};

/// Intersects a ray with a convex solid (note PL). Hit: it leaves the solid at t ≥ 0. Behind: at t < 0. Miss:
/// the line does not meet it. With a zero direction the case says so, and only the origin's place is set.
/// Where the line meets the solid:
/// (1) entered.t ≤ left.t, and they are the same exactly for One.
/// (2) A point of the line is not Outside exactly where its t lies between them, both included; between them
///     it is Inside for Two, On for Along.
/// (3) Each point of the two is that of its t, and lies in its face.
/// (4) k·r instead of r, k ≠ 0, divides both t by k and keeps points, faces and contacts; for k < 0 the two
///     change places.
template <class Scalar>
[[nodiscard]] RaySolid<Scalar> intersectRaySolid(const Ray<Scalar> &ray, const ConvexSolid<Scalar> &solid) {
  const Scalar zero(0);
  RaySolid<Scalar> result;
  // The ray in whole numbers, as the solid is: enough for all signs.
  const WeightedPoint<Scalar> origin = weighted(ray.origin);
  const Vec3<Scalar> direction = weighted(ray.direction).position;
  const std::vector<Scalar> products =
      productsWith({direction * origin.weight, cross(origin.position, direction)}, solid);

  bool inFacePlane = false;
  result.origin = SolidLocation::Inside;
  for (std::size_t i = 0; i < solid.faces.size(); ++i) {
    const auto &face = solid.faces[i];
    const Scalar f = evaluate(face.plane, origin);
    if (f > zero)
      result.origin = SolidLocation::Outside;
    else if (f == zero && result.origin == SolidLocation::Inside)
      result.origin = SolidLocation::On;
    const Scalar approach = dot(direction, face.plane.normal);
    if (approach == zero) {
      inFacePlane = inFacePlane || f == zero;
      continue;
    }
    auto &crossing = approach < zero ? result.entered : result.left;
    if (!crossing && crossesFace<Scalar>(face, products, approach > zero)) {
      const Scalar t = -evaluate(face.plane, ray.origin) / dot(ray.direction, face.plane.normal);
      crossing = {t, pointAt(ray, t), i};
    }
  }
  if (isZero(ray.direction))
    return result;
  if (!result.entered || !result.left) {
    result.which = RaySolidCase::Miss;
    return result;
  }
  result.which = result.left->t < zero ? RaySolidCase::Behind : RaySolidCase::Hit;
  result.contacts = result.entered->t == result.left->t ? SolidContacts::One
                    : inFacePlane                       ? SolidContacts::Along
                                                        : SolidContacts::Two;
  return result;
}

} // namespace halfspace
