// A line and a plane, by Plücker coordinates.
#pragma once

#include "geometry/line.h"
#include "geometry/plane.h"

namespace halfspace {

enum class LinePlaneCase { Point, Parallel, InPlane, NotALine, ZeroNormal };

/// Where a line meets a plane.
template <class Scalar> struct LinePlane {
  LinePlaneCase which = LinePlaneCase::NotALine;
  Vec3<Scalar> weighted{}; ///< n×m − d·direction: the common point times the weight
  Scalar weight{};         ///< n·direction; 0 when parallel
  Vec3<Scalar> point{};    ///< weighted/weight; set only for Point
};

/// Intersects a line with a plane in homogeneous coordinates (note PL). Parallel: the weight is 0 and the
/// point lies at infinity. InPlane: all four numbers are 0. With a zero normal, else with numbers of no real
/// line, the case says so; weighted point and weight are set in all of them.
/// (1) The point lies on the line and on the plane.
/// (2) k·line or k·[n, d], k ≠ 0, makes the weighted point and the weight k times as large and changes
///     nothing else.
/// (3) Of `lineOf` a ray the weight is the denominator of `intersectRayPlane`, and the point is the same;
///     where the weight is 0, the weighted point is numerator·r.
template <class Scalar>
[[nodiscard]] LinePlane<Scalar> intersectLinePlane(const Line<Scalar> &line, const Plane<Scalar> &plane) {
  LinePlane<Scalar> result;
  result.weighted = cross(plane.normal, line.moment) - line.direction * plane.offset;
  result.weight = dot(plane.normal, line.direction);
  if (isZero(plane.normal)) {
    result.which = LinePlaneCase::ZeroNormal;
  } else if (!isReal(line)) {
    result.which = LinePlaneCase::NotALine;
  } else if (result.weight == Scalar(0)) {
    result.which = isZero(result.weighted) ? LinePlaneCase::InPlane : LinePlaneCase::Parallel;
  } else {
    result.which = LinePlaneCase::Point;
    result.point = result.weighted * Scalar(Scalar(1) / result.weight);
  }
  return result;
}

} // namespace halfspace
