// Lines by their Plücker coordinates.
#pragma once

#include "geometry/ray.h"

#include <type_traits>

namespace halfspace {

/// The line {direction : moment} with moment = P×direction for each of its points P (note PL).
/// Any six numbers can be written so; they are those of a line only when `isReal`.
template <class Scalar> struct Line {
  Vec3<Scalar> direction;
  Vec3<Scalar> moment;
};

template <class Scalar>
[[nodiscard]] Line<Scalar> lineAlong(const Vec3<Scalar> &point, const Vec3<Scalar> &direction) {
  return {direction, cross(point, direction)};
}

/// From p to q: the direction is q − p.
template <class Scalar> [[nodiscard]] Line<Scalar> lineThrough(const Vec3<Scalar> &p, const Vec3<Scalar> &q) {
  return lineAlong(p, Vec3<Scalar>(q - p));
}

/// The whole line that a ray is a part of.
template <class Scalar> [[nodiscard]] Line<Scalar> lineOf(const Ray<Scalar> &ray) {
  return lineAlong(ray.origin, ray.direction);
}

/// direction·moment: zero for every line (note PL).
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

/// For a real line. Zero moment: the origin is one of its points.
template <class Scalar> [[nodiscard]] bool passesThroughOrigin(const Line<Scalar> &line) {
  return isZero(line.moment);
}

/// The point of a real line nearest to the origin: d×m/(d·d).
template <class Scalar> [[nodiscard]] Vec3<Scalar> nearestToOrigin(const Line<Scalar> &line) {
  return cross(line.direction, line.moment) * Scalar(Scalar(1) / dot(line.direction, line.direction));
}

/// d1·m2 + d2·m1: zero exactly when two lines meet or are parallel; its sign tells which way one passes the
/// other (note PL). Six times the signed volume of the tetrahedron of P1, P1 + d1, P2, P2 + d2, but for the
/// sign.
template <class Scalar>
[[nodiscard]] Scalar permutedInnerProduct(const Line<Scalar> &a, const Line<Scalar> &b) {
  return dot(a.direction, b.moment) + dot(b.direction, a.moment);
}

} // namespace halfspace
