// Where a point lies on a line: on its segment, on its ray, or beside it; by the point's coordinates alone.
#pragma once

#include "geometry/vector.h"

#include <array>
#include <cstddef>
#include <optional>

namespace halfspace {

/// How a point stands to the line through + t·direction: beside it, or on it with t < 0, with 0 ≤ t ≤ 1, or
/// with t > 1. The segment has both its ends, t = 0 and t = 1.
enum class LinePlace { Off, Before, Segment, Beyond, ZeroDirection };

/// A point and the line through + t·direction.
template <class Scalar> struct PlaceOnLine {
  LinePlace which = LinePlace::ZeroDirection;
  /// For each coordinate the t with which the line has it as the point does: none where the direction has a
  /// 0, because there the line has one coordinate for all t.
  std::array<std::optional<Scalar>, 3> steps{};
  Scalar t{}; ///< of the point itself; 0 where it is beside the line
};

/// Solves through + t·direction = point for t, coordinate by coordinate. The point is on the line exactly
/// where all coordinates ask for the same t, and where those that the direction does not change are right
/// already. With a zero direction the case says so, and nothing else is set. Else, over rationals:
/// (1) On the line point = through + t·direction.
/// (2) It is Off exactly where (point − through)×direction is not zero.
/// (3) k·direction instead of the direction, k ≠ 0, divides each t by k.
/// (4) From the other end of the segment, through + direction, back along −direction, each t is 1 − t, and
///     Before and Beyond change places.
template <class Scalar>
[[nodiscard]] PlaceOnLine<Scalar> placeOnLine(const Vec3<Scalar> &point, const Vec3<Scalar> &through,
                                              const Vec3<Scalar> &direction) {
  PlaceOnLine<Scalar> place;
  if (isZero(direction))
    return place;
  const Scalar zero(0);
  std::optional<Scalar> common;
  bool isOn = true;
  for (int axis = 0; axis < 3; ++axis) {
    const Scalar way = point[axis] - through[axis];
    if (direction[axis] == zero) {
      isOn = isOn && way == zero;
      continue;
    }
    const Scalar t = way / direction[axis];
    isOn = isOn && (!common || *common == t);
    common = t;
    place.steps.at(static_cast<std::size_t>(axis)) = t;
  }
  place.which = LinePlace::Off;
  if (!isOn)
    return place;
  place.t = *common;
  place.which = place.t < zero        ? LinePlace::Before
                : place.t > Scalar(1) ? LinePlace::Beyond
                                      : LinePlace::Segment;
  return place;
}

} // namespace halfspace
