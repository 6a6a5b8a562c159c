// A point and a line.
#pragma once

#include "geometry/surd.h"
#include "geometry/vector.h"

namespace halfspace {

enum class PointLineCase { Off, On, ZeroDirection };

/// How a point lies to a line.
template <class Scalar> struct PointLine {
  PointLineCase which = PointLineCase::ZeroDirection;
  Scalar t{};              ///< of the foot, in steps of the direction
  Vec3<Scalar> foot{};     ///< the line's point nearest to the point
  Root<Scalar> distance{}; ///< never negative
};

/// Measures a point against the line through `through` along `direction`. With a zero direction the case says
/// so, and nothing else is set. Else:
/// (1) t = (point − through)·direction / direction·direction, and foot = through + t·direction.
/// (2) (point − foot)·direction = 0.
/// (3) distance = |point − foot|, which is 0 exactly for On.
/// (4) |point − X|² = |point − foot|² + |foot − X|² for each point X of the line: none is nearer.
/// (5) Another point of the line as `through`, or k·direction with k ≠ 0, changes t alone.
template <class Scalar>
[[nodiscard]] PointLine<Scalar> measurePointLine(const Vec3<Scalar> &point, const Vec3<Scalar> &through,
                                                 const Vec3<Scalar> &direction) {
  PointLine<Scalar> result;
  if (isZero(direction))
    return result;
  result.t = dot(Vec3<Scalar>(point - through), direction) / dot(direction, direction);
  result.foot = through + direction * result.t;
  const Vec3<Scalar> way = point - result.foot;
  result.distance = timesRoot(Scalar(1), Scalar(dot(way, way)));
  result.which = isZero(way) ? PointLineCase::On : PointLineCase::Off;
  return result;
}

} // namespace halfspace
