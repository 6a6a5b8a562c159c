// A vector along another one and across it.
#pragma once

#include "geometry/surd.h"
#include "geometry/vector.h"

namespace halfspace {

enum class ProjectVectorCase { Projected, ZeroOnto };

/// A vector taken apart along a second one: vector = projection + rejection.
template <class Scalar> struct ProjectedVector {
  ProjectVectorCase which = ProjectVectorCase::ZeroOnto;
  Root<Scalar> scalar{};     ///< (vector·onto)/|onto|: the signed length of the projection
  Vec3<Scalar> projection{}; ///< ((vector·onto)/(onto·onto))·onto
  Vec3<Scalar> rejection{};  ///< vector − projection, perpendicular to onto
};

/// Projects a vector onto another (note PG 6.1). Onto a zero vector the case says so, and nothing else is
/// set. Else:
/// (1) vector = projection + rejection; projection is a multiple of onto, and rejection·onto = 0.
/// (2) |scalar| = |projection|, and its sign is that of vector·onto.
/// (3) Projected again, the projection stays as it is, and the rejection becomes 0.
/// (4) k·onto instead of onto, k ≠ 0, changes nothing but the scalar's sign, and that for k < 0.
template <class Scalar>
[[nodiscard]] ProjectedVector<Scalar> projectVector(const Vec3<Scalar> &vector, const Vec3<Scalar> &onto) {
  ProjectedVector<Scalar> result;
  if (isZero(onto))
    return result;
  const Scalar product = dot(vector, onto);
  const Scalar square = dot(onto, onto);
  result.which = ProjectVectorCase::Projected;
  result.scalar = overRoot(product, square);
  result.projection = onto * Scalar(product / square);
  result.rejection = vector - result.projection;
  return result;
}

} // namespace halfspace
