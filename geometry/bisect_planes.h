// The planes that halve the angles of two planes.
#pragma once

#include "geometry/exact_root.h"
#include "geometry/intersect_planes.h"

#include <array>

namespace halfspace {

/// Irrational: the planes cross, and the ratio of the normals' lengths has a root, so that no multiples of
/// the halving planes' normals are fractions.
enum class BisectPlanesCase { Crossing, Irrational, Parallel, Coincident, ZeroNormal };

/// All points that are equally far from two planes.
struct BisectedPlanes {
  BisectPlanesCase which = BisectPlanesCase::ZeroNormal;
  Surd ratio{}; ///< |n2|/|n1|: so many times n1 is as long as n2
  /// [n2, d2] + ratio·[n1, d1] and [n2, d2] − ratio·[n1, d1], where the ratio is a fraction; of Parallel and
  /// Coincident planes one of them has a zero normal.
  std::array<Plane<Rational>, 2> planes{};
};

/// Finds the points that are equally far from two planes: those at which f2 is ±ratio·f1. With a zero normal
/// the case says so, and nothing else is set.
/// (1) Each point of the planes is as far from the first as from the second, where their normals are not
///     zero; no other point is, but of Coincident planes, where all points are.
/// (2) The two are perpendicular to each other, and contain the line in which the planes meet.
/// (3) Of Parallel planes one is left, halfway between them. Of Coincident ones it is these themselves.
/// (4) k·[n, d], k > 0, instead of one of the planes makes the same planes; k < 0 changes their places.
/// (5) Irrational exactly where the planes cross and (n1·n1)(n2·n2) is no square of a fraction.
[[nodiscard]] inline BisectedPlanes bisectPlanes(const Plane<Rational> &a, const Plane<Rational> &b) {
  BisectedPlanes result;
  const PlanePlaneCase meet = intersectPlanes(a, b).which;
  if (meet == PlanePlaneCase::ZeroNormal)
    return result;
  const Rational square = dot(b.normal, b.normal) / dot(a.normal, a.normal);
  result.ratio = Surd::root(square);
  const std::optional<Rational> ratio = exactRoot(square);
  if (!ratio) {
    result.which = BisectPlanesCase::Irrational;
    return result;
  }
  result.planes = {Plane<Rational>{b.normal + a.normal * *ratio, b.offset + a.offset * *ratio},
                   Plane<Rational>{b.normal - a.normal * *ratio, b.offset - a.offset * *ratio}};
  result.which = meet == PlanePlaneCase::Line       ? BisectPlanesCase::Crossing
                 : meet == PlanePlaneCase::Parallel ? BisectPlanesCase::Parallel
                                                    : BisectPlanesCase::Coincident;
  return result;
}

} // namespace halfspace
