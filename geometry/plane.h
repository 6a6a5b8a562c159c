// The implicit plane n·x + d = 0.
#pragma once

#include "geometry/surd.h"
#include "geometry/vector.h"

#include <array>
#include <cassert>

namespace halfspace {

/// The points x with normal·x + offset = 0. The positive side is the one that the normal points to.
/// A zero normal is no plane: the queries say so by a case of their own.
template <class Scalar> struct Plane {
  Vec3<Scalar> normal;
  Scalar offset;
};

/// The plane through a point: d = −n·P0 (note PG 1).
/// (1) f(P0) = 0.
/// (2) The same for each point of the plane.
template <class Scalar>
[[nodiscard]] Plane<Scalar> planeThrough(const Vec3<Scalar> &point, const Vec3<Scalar> &normal) {
  return {normal, Scalar(-dot(normal, point))};
}

/// The plane through three points with the normal (p1 − p0)×(p2 − p0): on its positive side they are seen
/// counterclockwise.
/// (1) f is 0 at all three.
/// (2) The same for the points in turn (p1, p2, p0), the negative [n, d] with two of them swapped.
/// (3) Normal and offset are zero exactly where the points lie on one line.
template <class Scalar>
[[nodiscard]] Plane<Scalar> planeThrough(const Vec3<Scalar> &p0, const Vec3<Scalar> &p1,
                                         const Vec3<Scalar> &p2) {
  return planeThrough(p0, cross(Vec3<Scalar>(p1 - p0), Vec3<Scalar>(p2 - p0)));
}

/// f(x) = n·x + d: zero on the plane, its sign is the side of x (note PG 3.4). A distance only when |n| = 1.
/// (1) f(x + v) = f(x) + n·v.
/// (2) The plane k·[n, d] gives k·f(x).
template <class Scalar> [[nodiscard]] Scalar evaluate(const Plane<Scalar> &plane, const Vec3<Scalar> &x) {
  return dot(plane.normal, x) + plane.offset;
}

/// [a, b, c, d] divided by |n| (note PG 3.3). Requires n ≠ 0.
/// (1) a² + b² + c² = 1.
/// (2) The same for k·[n, d] with k > 0, the negatives for k < 0.
/// (3) f with them is the signed distance of `measurePointPlane`.
template <class Scalar>
[[nodiscard]] std::array<Root<Scalar>, 4> normalizedCoefficients(const Plane<Scalar> &plane) {
  assert(!isZero(plane.normal));
  const Scalar square = dot(plane.normal, plane.normal);
  return {overRoot(plane.normal.x, square), overRoot(plane.normal.y, square),
          overRoot(plane.normal.z, square), overRoot(plane.offset, square)};
}

/// The positive multiple of [a, b, c, d] in whole numbers without a common factor. Requires n ≠ 0.
/// (1) They are in the proportion of the coefficients, with the same signs.
/// (2) Their greatest common divisor is 1.
/// (3) The same for k·[n, d] with k > 0, the negatives for k < 0.
[[nodiscard]] std::array<Rational, 4> primitiveCoefficients(const Plane<Rational> &plane);

} // namespace halfspace
