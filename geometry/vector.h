// Points and vectors of three coordinates, over doubles or fractions.
//
// The numbered laws at the declarations of this folder hold for all that a declaration takes: exactly over
// fractions, up to rounding over doubles, unless they say otherwise. Tests cite them by number.
#pragma once

#include "geometry/rational.h"

#include <glm/vec3.hpp>

namespace halfspace {

/// Three coordinates of a point or a vector. GLM's own dot and cross refuse a class type: those below serve
/// both.
template <class Scalar> using Vec3 = glm::vec<3, Scalar>;

/// a·b
template <class Scalar> [[nodiscard]] Scalar dot(const Vec3<Scalar> &a, const Vec3<Scalar> &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// a×b, right-handed: the first axis × the second is the third.
/// (1) b×a = −(a×b).
/// (2) a·(a×b) = b·(a×b) = 0.
/// (3) |a×b|² = |a|²|b|² − (a·b)²: a×b = 0 exactly where one is a multiple of the other.
/// (4) a·(b×c) = b·(c×a) = c·(a×b).
template <class Scalar> [[nodiscard]] Vec3<Scalar> cross(const Vec3<Scalar> &a, const Vec3<Scalar> &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Scalar> [[nodiscard]] bool isZero(const Vec3<Scalar> &v) {
  return v.x == Scalar(0) && v.y == Scalar(0) && v.z == Scalar(0);
}

/// The doubles nearest to the coordinates.
[[nodiscard]] inline Vec3<double> toDouble(const Vec3<Rational> &v) {
  return {toDouble(v.x), toDouble(v.y), toDouble(v.z)};
}

} // namespace halfspace
