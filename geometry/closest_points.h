// Where two lines come nearest to each other, by how many steps along each of them.
#pragma once

#include "geometry/point_line.h"

namespace halfspace {

enum class ClosestPointsCase { Skew, Meet, Parallel, Coincident, ZeroDirection };

/// How two lines pass each other.
template <class Scalar> struct ClosestPoints {
  ClosestPointsCase which = ClosestPointsCase::ZeroDirection;
  Vec3<Scalar> normal{};   ///< v × w, perpendicular to both directions
  Scalar volume{};         ///< of the box of v, w and the way from A to B, with its sign
  Scalar s{};              ///< of the first point, in steps of v; 0 without a single pair
  Scalar t{};              ///< of the second point, in steps of w; 0 without a single pair
  Vec3<Scalar> first{};    ///< A + s·v
  Vec3<Scalar> second{};   ///< B + t·w
  Root<Scalar> distance{}; ///< never negative
};

/// The closest points of the lines A + s·v and B + t·w. The way between them is perpendicular to v and to w:
/// two equations for s and t, which Cramer's rule solves. Their determinant is (v·v)(w·w) − (v·w)² =
/// |v × w|², 0 exactly for parallel directions. `nearestPoints` has the same points by Plücker coordinates.
///
/// With a zero direction the case says so, and nothing but the normal and the volume is set. Parallel lines
/// have no single pair: of them only the case and the distance are set, too. Else, with first and second:
/// (1) (second − first)·v = (second − first)·w = 0.
/// (2) No two points of the lines are nearer: |X − Y|² = |first − second|² + |(X − first) − (Y − second)|²
///     for each X of one and Y of the other.
/// (3) distance = |first − second| = |volume|/|normal|, which is 0 exactly for Meet.
/// (4) Another A or B of the same lines, or multiples of v and w, ≠ 0, give the same points.
/// (5) The lines the other way round have the points, s and t the other way round.
/// Of parallel lines the distance is that of B from the first line, which is 0 exactly for Coincident.
template <class Scalar>
[[nodiscard]] ClosestPoints<Scalar> closestPoints(const Vec3<Scalar> &A, const Vec3<Scalar> &v,
                                                  const Vec3<Scalar> &B, const Vec3<Scalar> &w) {
  const Vec3<Scalar> between = B - A;
  ClosestPoints<Scalar> result;
  result.normal = cross(v, w);
  result.volume = dot(result.normal, between);
  if (isZero(v) || isZero(w))
    return result;
  if (isZero(result.normal)) {
    const PointLine<Scalar> measured = measurePointLine(B, A, v);
    result.which =
        measured.which == PointLineCase::On ? ClosestPointsCase::Coincident : ClosestPointsCase::Parallel;
    result.distance = measured.distance;
    return result;
  }
  const Scalar zero(0);
  const Scalar square = dot(result.normal, result.normal);
  const Scalar vw = dot(v, w);
  const Scalar alongV = dot(between, v);
  const Scalar alongW = dot(between, w);
  result.which = result.volume == zero ? ClosestPointsCase::Meet : ClosestPointsCase::Skew;
  result.s = (alongV * dot(w, w) - alongW * vw) / square;
  result.t = (alongV * vw - alongW * dot(v, v)) / square;
  result.first = A + v * result.s;
  result.second = B + w * result.t;
  result.distance = overRoot(result.volume < zero ? Scalar(-result.volume) : result.volume, square);
  return result;
}

} // namespace halfspace
