// Two lines.
#pragma once

#include "geometry/line.h"
#include "geometry/surd.h"

namespace halfspace {

/// Same and Opposite: the same points, with directions that agree or oppose each other.
enum class LineLineCase { Same, Opposite, Parallel, Intersecting, Skew, NotALine };

/// How two lines lie to each other, with every number on the way.
template <class Scalar> struct LineLine {
  LineLineCase which = LineLineCase::NotALine;
  Scalar product{};           ///< the permuted inner product d1·m2 + d2·m1
  bool perpendicular = false; ///< d1·d2 = 0; skew lines can be, too
  Root<Scalar> distance{};    ///< 0 where they meet
  Vec3<Scalar> point{};       ///< set only for Intersecting
};

/// The points where two lines come nearest to each other: the feet of their common perpendicular.
template <class Scalar> struct NearestPoints {
  Vec3<Scalar> first{};
  Vec3<Scalar> second{};
};

/// Requires real lines that are not parallel.
/// (1) The first point lies on a, the second on b, and the way between them is perpendicular to both.
/// (2) The points are the same exactly where the lines meet.
/// (3) nearestPoints(b, a) has them the other way round.
template <class Scalar>
[[nodiscard]] NearestPoints<Scalar> nearestPoints(const Line<Scalar> &a, const Line<Scalar> &b) {
  const Vec3<Scalar> common = cross(a.direction, b.direction);
  const Scalar square = dot(common, common);
  const Vec3<Scalar> onA = nearestToOrigin(a);
  const Vec3<Scalar> onB = nearestToOrigin(b);
  const Vec3<Scalar> between = onB - onA;
  const Scalar alongA = dot(cross(between, b.direction), common) / square;
  const Scalar alongB = dot(cross(between, a.direction), common) / square;
  return {onA + a.direction * alongA, onB + b.direction * alongB};
}

/// How two lines lie to each other (note PL). If one of them is not real, the case says so and only the
/// product is set. Of real lines:
/// (1) relateLines(b, a) is the same.
/// (2) The product is ≠ 0 exactly for Skew.
/// (3) The distance is 0 exactly for Same, Opposite and Intersecting, never negative, and |product|/|d1×d2|
///     where the lines are not parallel.
/// (4) The point of Intersecting lies on both lines.
/// (5) k·a instead of a, k ≠ 0: the product is k times as large, and for k < 0 Same and Opposite change
///     places; all else stays.
template <class Scalar>
[[nodiscard]] LineLine<Scalar> relateLines(const Line<Scalar> &a, const Line<Scalar> &b) {
  const Scalar zero(0);
  LineLine<Scalar> result;
  result.product = permutedInnerProduct(a, b);
  if (!isReal(a) || !isReal(b))
    return result;

  const Scalar cosine = dot(a.direction, b.direction);
  const Vec3<Scalar> common = cross(a.direction, b.direction);
  const Vec3<Scalar> between = nearestToOrigin(b) - nearestToOrigin(a);
  result.perpendicular = cosine == zero;
  result.distance = Root<Scalar>(0);
  if (isZero(common)) {
    if (isZero(between)) {
      result.which = cosine > zero ? LineLineCase::Same : LineLineCase::Opposite;
    } else {
      // Both nearest points lie in the plane through the origin across the lines: the way between is the
      // distance.
      result.which = LineLineCase::Parallel;
      result.distance = timesRoot(Scalar(1), dot(between, between));
    }
    return result;
  }
  const Scalar square = dot(common, common);
  if (result.product != zero) {
    result.which = LineLineCase::Skew;
    result.distance = overRoot(result.product < zero ? Scalar(-result.product) : result.product, square);
    return result;
  }
  result.which = LineLineCase::Intersecting;
  result.point = nearestPoints(a, b).first;
  return result;
}

} // namespace halfspace
