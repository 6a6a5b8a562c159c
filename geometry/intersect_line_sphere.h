// A line and a sphere.
#pragma once

#include "geometry/location.h"
#include "geometry/sphere.h"
#include "geometry/surd.h"

#include <array>
#include <vector>

namespace halfspace {

/// In how many points a line meets a sphere.
enum class SphereContacts { None, Tangent, Two };

/// One point that a line and a sphere have in common.
template <class Scalar> struct SphereContact {
  Root<Scalar> t{};
  std::array<Root<Scalar>, 3> point{};
  std::array<Root<Scalar>, 3> normal{}; ///< unit, outward
};

/// Where a line meets a sphere, with every number on the way. With m = through − center:
template <class Scalar> struct LineSphere {
  SphereContacts contacts = SphereContacts::None;
  SolidLocation origin = SolidLocation::Outside; ///< where `through` lies
  Scalar power{};                                ///< m·m − r²: negative inside, 0 on the sphere
  Scalar leaving{};                              ///< d·m: positive where d leads away from the center
  Scalar discriminant{};                         ///< (d·m)² − (d·d)(m·m − r²)
  std::vector<SphereContact<Scalar>> along{};    ///< by ascending t
};

/// Intersects the line through a point along d with a sphere (note CG). With a zero direction only the place
/// of the point and its power are set. Requires a radius > 0.
/// (1) Each contact is through + t·d, and |contact − center| = radius.
/// (2) Its normal is (contact − center)/radius, so that its length is 1.
/// (3) The discriminant is (d·d)(radius² − distance²), with the distance of the center from the line: it is
///     negative, 0 or positive exactly for None, Tangent and Two.
/// (4) The two t have the sum −2(d·m)/(d·d) and the product power/(d·d), which is negative, 0 or positive for
///     a point Inside, On and Outside. For Tangent both are the one t.
/// (5) k·d instead of d, k ≠ 0, divides each t by k and keeps the points and normals, in the opposite order
///     for k < 0.
template <class Scalar>
[[nodiscard]] LineSphere<Scalar> intersectLineSphere(const Vec3<Scalar> &through, const Vec3<Scalar> &d,
                                                     const Sphere<Scalar> &sphere) {
  const Scalar zero(0);
  LineSphere<Scalar> result;
  const Vec3<Scalar> m = through - sphere.center;
  result.power = dot(m, m) - sphere.radius * sphere.radius;
  result.origin = result.power > zero   ? SolidLocation::Outside
                  : result.power < zero ? SolidLocation::Inside
                                        : SolidLocation::On;
  if (isZero(d))
    return result;
  const Scalar square = dot(d, d);
  result.leaving = dot(d, m);
  result.discriminant = result.leaving * result.leaving - square * result.power;
  if (result.discriminant < zero)
    return result;
  result.contacts = result.discriminant == zero ? SphereContacts::Tangent : SphereContacts::Two;

  const Scalar middle = -result.leaving / square;
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
