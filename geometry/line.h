// Lines by their Plücker coordinates.
#pragma once

#include "geometry/ray.h"

#include <type_traits>

namespace halfspace {

/// The line {direction : moment} with moment = P×direction for each of its points P (note PL).
/// Any six numbers can be written so; they are those of a line only when `isReal`. Their multiple k·line is
/// the same line for k > 0, and the line turned round for k < 0.
template <class Scalar> struct Line {
  Vec3<Scalar> direction;
  Vec3<Scalar> moment;
};

/// The line through a point, real for a direction ≠ 0.
/// (1) Its relation is 0.
/// (2) The same for each of its points: lineAlong(P + t·d, d) = lineAlong(P, d).
template <class Scalar>
[[nodiscard]] Line<Scalar> lineAlong(const Vec3<Scalar> &point, const Vec3<Scalar> &direction) {
  return {direction, cross(point, direction)};
}

/// From p to q: the direction is q − p. Real for p ≠ q.
/// (1) The moment is p×q.
/// (2) lineThrough(q, p) is the negative of lineThrough(p, q).
template <class Scalar> [[nodiscard]] Line<Scalar> lineThrough(const Vec3<Scalar> &p, const Vec3<Scalar> &q) {
  return lineAlong(p, Vec3<Scalar>(q - p));
}

/// The whole line that a ray is a part of.
template <class Scalar> [[nodiscard]] Line<Scalar> lineOf(const Ray<Scalar> &ray) {
  return lineAlong(ray.origin, ray.direction);
}

/// direction·moment: zero for every real line (note PL).
template <class Scalar> [[nodiscard]] Scalar relation(const Line<Scalar> &line) {
  return dot(line.direction, line.moment);
}

/// Whether the six numbers are those of a line: relation 0 and direction ≠ 0. Over doubles the relation is
/// not asked: there it is 0 by luck alone.
template <class Scalar> [[nodiscard]] bool isReal(const Line<Scalar> &line) {
  if constexpr (!std::is_floating_point_v<Scalar>)
    if (relation(line) != Scalar(0))
      return false;
  return !isZero(line.direction);
}

/// Whether the moment is zero, and so the origin one of the points. Requires a real line.
template <class Scalar> [[nodiscard]] bool passesThroughOrigin(const Line<Scalar> &line) {
  return isZero(line.moment);
}

/// The point N nearest to the origin: d×m/(d·d). Requires a real line.
/// (1) N lies on the line: N×d = m.
/// (2) N·d = 0.
/// (3) The same for k·line, k ≠ 0.
/// (4) N = 0 exactly where `passesThroughOrigin`.
template <class Scalar> [[nodiscard]] Vec3<Scalar> nearestToOrigin(const Line<Scalar> &line) {
  return cross(line.direction, line.moment) * Scalar(Scalar(1) / dot(line.direction, line.direction));
}

/// d1·m2 + d2·m1: its sign tells which way one line passes the other (note PL). Positive: looked at against
/// the direction of a, b passes it counterclockwise.
/// (1) product(b, a) = product(a, b).
/// (2) product(k·a, b) = k·product(a, b): turning one of the lines round changes the sign.
/// (3) −(P2 − P1)·(d1×d2) for lines through P1 and P2: six times the signed volume of the tetrahedron of P1,
///     P1 + d1, P2, P2 + d2, but for the sign.
/// (4) Of real lines 0 exactly where they meet or are parallel.
/// (5) product(a, a) = 2·relation(a).
template <class Scalar>
[[nodiscard]] Scalar permutedInnerProduct(const Line<Scalar> &a, const Line<Scalar> &b) {
  return dot(a.direction, b.moment) + dot(b.direction, a.moment);
}

} // namespace halfspace
