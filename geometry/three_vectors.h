// Three vectors, and the box that they span.
#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// The box is flat in the last three: Parallel has two vectors ≠ 0 along one line, Flat none.
enum class ThreeVectorsCase { RightHanded, LeftHanded, Flat, Parallel, ZeroVector };

/// How three vectors u, v, w stand to each other, with every number on the way.
template <class Scalar> struct ThreeVectors {
  ThreeVectorsCase which = ThreeVectorsCase::ZeroVector;
  Vec3<Scalar> normal{}; ///< u×v, as long as the area of the box's base
  Scalar determinant{};  ///< (u×v)·w: the volume of the box, negative for LeftHanded
  Vec3<Scalar> other{};  ///< v×w
  Vec3<Scalar> twice{};  ///< u×(v×w)
};

/// Looks at three vectors in their order.
/// (1) With two of them exchanged the determinant has the other sign; with all moved on, v w u, it is the
///     same.
/// (2) It is 0 exactly for Flat, Parallel and ZeroVector.
/// (3) w + a·u + b·v instead of w: the same, and k·w: k times as large.
/// (4) |determinant| ≤ |u||v||w|, with equality exactly where all are perpendicular or one is zero.
/// (5) u×(v×w) = (u·w)v − (u·v)w, and it is perpendicular to u and to v×w.
template <class Scalar>
[[nodiscard]] ThreeVectors<Scalar> relateVectors(const Vec3<Scalar> &u, const Vec3<Scalar> &v,
                                                 const Vec3<Scalar> &w) {
  const Scalar zero(0);
  ThreeVectors<Scalar> result;
  result.normal = cross(u, v);
  result.determinant = dot(result.normal, w);
  result.other = cross(v, w);
  result.twice = cross(u, result.other);
  if (result.determinant > zero)
    result.which = ThreeVectorsCase::RightHanded;
  else if (result.determinant < zero)
    result.which = ThreeVectorsCase::LeftHanded;
  else if (isZero(u) || isZero(v) || isZero(w))
    result.which = ThreeVectorsCase::ZeroVector;
  else if (isZero(result.normal) || isZero(result.other) || isZero(cross(w, u)))
    result.which = ThreeVectorsCase::Parallel;
  else
    result.which = ThreeVectorsCase::Flat;
  return result;
}

} // namespace halfspace
