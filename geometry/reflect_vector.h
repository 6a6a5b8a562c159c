// A direction that a mirror turns round.
#pragma once

#include "geometry/project_vector.h"

#include <cassert>

namespace halfspace {

/// The direction in which a ray goes on when a plane with this normal reflects it: vector −
/// 2((vector·normal)/(normal·normal))·normal. Requires a normal ≠ 0.
/// (1) Its part along the normal is the opposite of the vector's, and its part across is the same.
/// (2) Its length is that of the vector.
/// (3) Reflected again, it is the vector.
/// (4) k·normal instead of the normal, k ≠ 0, changes nothing.
template <class Scalar>
[[nodiscard]] Vec3<Scalar> reflectVector(const Vec3<Scalar> &vector, const Vec3<Scalar> &normal) {
  assert(!isZero(normal));
  return vector - projectVector(vector, normal).projection * Scalar(2);
}

} // namespace halfspace
