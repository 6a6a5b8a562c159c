// Angles by their cosines: of two directions, and of the lines along them.
#pragma once

#include "geometry/surd.h"
#include "geometry/vector.h"

namespace halfspace {

/// The cosine of the angle from 0° to 180° between two vectors: (a·b)/(|a||b|); 0 where one of them is zero,
/// so that there is no angle.
/// (1) cosineBetween(b, a) is the same.
/// (2) k·a instead of a changes nothing for k > 0, and the sign for k < 0.
/// (3) It is 1 or −1 exactly where the vectors ≠ 0 are multiples of each other, and 0 exactly where a·b = 0.
template <class Scalar>
[[nodiscard]] Root<Scalar> cosineBetween(const Vec3<Scalar> &a, const Vec3<Scalar> &b) {
  const Scalar squares = dot(a, a) * dot(b, b);
  return squares == Scalar(0) ? Root<Scalar>(0) : overRoot(dot(a, b), squares);
}

enum class AcuteAngleCase { Parallel, Oblique, Perpendicular, ZeroVector };

/// The angle from 0° to 90° at which lines along two vectors run to each other.
template <class Scalar> struct AcuteAngle {
  AcuteAngleCase which = AcuteAngleCase::ZeroVector;
  Scalar product{};      ///< a·b, with its sign
  Root<Scalar> cosine{}; ///< |a·b|/(|a||b|)
  Root<Scalar> sine{};   ///< |a×b|/(|a||b|)
};

/// Measures the lines along two vectors. With a zero vector the case says so, and nothing else is set. Else:
/// (1) measureAcuteAngle(b, a) is the same.
/// (2) k·a instead of a, k ≠ 0: the product is k times as large, all else stays.
/// (3) Cosine and sine are never negative, and cosine² + sine² = 1.
/// (4) The sine is 0 exactly for Parallel, the cosine exactly for Perpendicular.
template <class Scalar>
[[nodiscard]] AcuteAngle<Scalar> measureAcuteAngle(const Vec3<Scalar> &a, const Vec3<Scalar> &b) {
  AcuteAngle<Scalar> result;
  if (isZero(a) || isZero(b))
    return result;
  const Vec3<Scalar> across = cross(a, b);
  const Scalar squares = dot(a, a) * dot(b, b);
  result.product = dot(a, b);
  result.which = isZero(across)                ? AcuteAngleCase::Parallel
                 : result.product == Scalar(0) ? AcuteAngleCase::Perpendicular
                                               : AcuteAngleCase::Oblique;
  const Root<Scalar> cosine = cosineBetween(a, b);
  result.cosine = cosine < Root<Scalar>(0) ? Root<Scalar>(-cosine) : cosine;
  result.sine = timesRoot(Scalar(1), Scalar(dot(across, across) / squares));
  return result;
}

} // namespace halfspace
