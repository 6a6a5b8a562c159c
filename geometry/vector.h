// Points and vectors of three coordinates, over doubles or fractions.
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

/// a×b, right-handed.
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
