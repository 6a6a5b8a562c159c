// A ray and a sphere.
#pragma once

#include "geometry/intersect_line_sphere.h"
#include "geometry/ray.h"

namespace halfspace {

enum class RaySphereCase { Hit, Behind, Miss, ZeroDirection };

/// Where a ray meets a sphere: what its whole line meets, and whether the ray gets there.
template <class Scalar> struct RaySphere : LineSphere<Scalar> {
  RaySphereCase which = RaySphereCase::ZeroDirection;
};

/// Whether a ray gets to what its line meets, its start being the line's point. Hit: some t ≥ 0, which is so
/// when the ray starts inside or on the sphere. Behind: all t < 0. Miss: the discriminant is negative.
/// (1) Hit, Behind and Miss as the t of the contacts tell, ZeroDirection where the direction is zero.
template <class Scalar> [[nodiscard]] RaySphereCase caseOfRay(const LineSphere<Scalar> &line) {
  const Scalar zero(0);
  if (line.contacts == SphereContacts::None) // a line with a direction has a contact where this is 0
    return line.discriminant < zero ? RaySphereCase::Miss : RaySphereCase::ZeroDirection;
  // The two t have the product power/d·d: from outside both have the sign of −leaving.
  return line.power > zero && line.leaving > zero ? RaySphereCase::Behind : RaySphereCase::Hit;
}

/// Intersects a ray with a sphere (note CG). With a zero direction the case says so, and only the origin's
/// place and power are set. Requires a radius > 0.
/// (1) All but the case is what `intersectLineSphere` says of the ray's line, with its laws.
template <class Scalar>
[[nodiscard]] RaySphere<Scalar> intersectRaySphere(const Ray<Scalar> &ray, const Sphere<Scalar> &sphere) {
  RaySphere<Scalar> result{intersectLineSphere(ray.origin, ray.direction, sphere),
                           RaySphereCase::ZeroDirection};
  result.which = caseOfRay(result);
  return result;
}

} // namespace halfspace
