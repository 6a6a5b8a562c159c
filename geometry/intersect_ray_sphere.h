// A ray and a sphere.
#pragma once

#include "geometry/location.h"
#include "geometry/ray.h"
#include "geometry/sphere.h"
#include "geometry/surd.h"

#include <array>
#include <vector>

namespace halfspace {

enum class RaySphereCase { Hit, Behind, Miss, ZeroDirection };
/// In how many points the whole line meets the sphere.
enum class SphereContacts { None, Tangent, Two };

/// One point that a ray's line and a sphere have in common.
template <class Scalar> struct SphereContact {
  Root<Scalar> t{};
  std::array<Root<Scalar>, 3> point{};
  std::array<Root<Scalar>, 3> normal{}; ///< unit, outward
};

/// Where a ray meets a sphere, with every number on the way.
template <class Scalar> struct RaySphere {
  RaySphereCase which = RaySphereCase::ZeroDirection;
  SphereContacts contacts = SphereContacts::None;
  SolidLocation origin = SolidLocation::Outside; ///< where the ray starts
  Scalar discriminant{}; ///< (d·m)² − (d·d)(m·m − r²) with m = origin − center
  std::vector<SphereContact<Scalar>> along{}; ///< by ascending t
};

/// Intersects a ray with a sphere (note CG). Hit: some t ≥ 0, which is so when the ray starts inside or on
/// it. Behind: all t < 0. Miss: the discriminant is negative. With a zero direction the case says so and only
/// the origin's place is set. Requires a radius > 0.
/// (1) Each contact is Q + t·d, and |contact − center| = radius.
/// (2) Its normal is (contact − center)/radius, so that its length is 1.
/// (3) The discriminant is (d·d)(radius² − distance²), with the distance of the center from the line: it is
///     negative, 0 or positive exactly for None, Tangent and Two.
/// (4) The two t have the sum −2(d·m)/(d·d) and the product (m·m − radius²)/(d·d), which is negative, 0 or
///     positive for an origin Inside, On and Outside. For Tangent both are the one t.
/// (5) k·d instead of d, k ≠ 0, divides each t by k and keeps the points and normals, in the opposite order
///     for k < 0.
template <class Scalar>
[[nodiscard]] RaySphere<Scalar> intersectRaySphere(const Ray<Scalar> &ray, const Sphere<Scalar> &sphere) {
  const Scalar zero(0);
  RaySphere<Scalar> result;
  const Vec3<Scalar> &d = ray.direction;
  const Vec3<Scalar> m = ray.origin - sphere.center;
  const Scalar outside = dot(m, m) - sphere.radius * sphere.radius;
  result.origin = outside > zero   ? SolidLocation::Outside
                  : outside < zero ? SolidLocation::Inside
                                   : SolidLocation::On;
  if (isZero(d))
    return result;
  const Scalar square = dot(d, d);
  const Scalar leaving = dot(d, m);
  result.discriminant = leaving * leaving - square * outside;
  if (result.discriminant < zero) {
    result.which = RaySphereCase::Miss;
    return result;
  }
  // The two t have the product outside/square: from outside both have the sign of −leaving.
  result.which = outside > zero && leaving > zero ? RaySphereCase::Behind : RaySphereCase::Hit;
  result.contacts = result.discriminant == zero ? SphereContacts::Tangent : SphereContacts::Two;

  const Scalar middle = -leaving / square;
  const Scalar share = Scalar(1) / square;
  const Scalar perRadius = Scalar(1) / sphere.radius;
  const auto addContact = [&](const Root<Scalar> &t) {
    SphereContact<Scalar> contact;
    contact.t = t;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<glm::length_t>(i);
      const Root<Scalar> fromCenter = t * d[axis] + m[axis];
      contact.point[i] = fromCenter + sphere.center[axis];
      contact.normal[i] = fromCenter * perRadius;
    }
    result.along.push_back(std::move(contact));
  };
  if (result.contacts == SphereContacts::Tangent) {
    addContact(Root<Scalar>(middle));
  } else {
    const Root<Scalar> root = timesRoot(share, result.discriminant);
    addContact(-root + middle);
    addContact(root + middle);
  }
  return result;
}

} // namespace halfspace
