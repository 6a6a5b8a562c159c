// Three planes, by Cramer's rule.
#pragma once

#include "geometry/intersect_planes.h"

#include <algorithm>
#include <array>

namespace halfspace {

/// Line: all points that the three share; two of the planes may be the same then. Prism: each two meet in a
/// line of their own, and no point is in all three. Parallel: two at least are parallel and not the same.
enum class ThreePlanesCase { Point, Line, Prism, Parallel, Coincident, ZeroNormal };

/// What three planes have in common, with every number on the way.
template <class Scalar> struct ThreePlanes {
  ThreePlanesCase which = ThreePlanesCase::ZeroNormal;
  /// n2×n3, n3×n1, n1×n2: along the lines in which two of the planes meet, the one that is left out first.
  std::array<Vec3<Scalar>, 3> directions{};
  Scalar weight{};         ///< n1·(n2×n3); 0 where no single point is shared
  Vec3<Scalar> weighted{}; ///< −(d1·n2×n3 + d2·n3×n1 + d3·n1×n2): the common point times the weight
  Vec3<Scalar> point{};    ///< weighted/weight; set only for Point
};

/// Intersects three planes. With a zero normal the case says so, and the other numbers are set all the same.
/// (1) The point lies in all three planes.
/// (2) The weight is 0 exactly where the case is not Point.
/// (3) With two of the planes exchanged weight and weighted point are the negative ones; in a circle, b c a,
///     they stay. Case and point are the same in any order.
/// (4) k·[n, d] instead of one of them, k ≠ 0, makes weight and weighted point k times as large and changes
///     neither case nor point.
/// (5) Where the weight is 0 and normals are not all along one line, the weighted point runs along all three
///     planes. It is 0 exactly for Line.
template <class Scalar>
[[nodiscard]] ThreePlanes<Scalar> intersectPlanes(const Plane<Scalar> &a, const Plane<Scalar> &b,
                                                  const Plane<Scalar> &c) {
  ThreePlanes<Scalar> result;
  result.directions = {cross(b.normal, c.normal), cross(c.normal, a.normal), cross(a.normal, b.normal)};
  const auto &[bc, ca, ab] = result.directions;
  result.weight = dot(a.normal, bc);
  result.weighted = -(bc * a.offset + ca * b.offset + ab * c.offset);
  if (isZero(a.normal) || isZero(b.normal) || isZero(c.normal))
    return result;
  const auto isNone = [](const Vec3<Scalar> &direction) { return isZero(direction); };
  const auto areSame = [](const Plane<Scalar> &one, const Plane<Scalar> &other) {
    return intersectPlanes(one, other).which == PlanePlaneCase::Coincident;
  };
  if (result.weight != Scalar(0)) {
    result.which = ThreePlanesCase::Point;
    result.point = result.weighted * Scalar(Scalar(1) / result.weight);
  } else if (std::all_of(result.directions.begin(), result.directions.end(), isNone)) {
    result.which = areSame(a, b) && areSame(a, c) ? ThreePlanesCase::Coincident : ThreePlanesCase::Parallel;
  } else if (isZero(result.weighted)) {
    result.which = ThreePlanesCase::Line;
  } else {
    const bool areTwoAlong = std::any_of(result.directions.begin(), result.directions.end(), isNone);
    result.which = areTwoAlong ? ThreePlanesCase::Parallel : ThreePlanesCase::Prism;
  }
  return result;
}

} // namespace halfspace
