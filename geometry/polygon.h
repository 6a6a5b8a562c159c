// Planar convex polygons.
#pragma once

#include "geometry/weighted_point.h"

#include <span>
#include <utility>
#include <vector>

namespace halfspace {

/// Corners in order around; at least three.
template <class Scalar> using Polygon = std::vector<Vec3<Scalar>>;

/// Convex is meant strictly: a repeated corner, a straight one and corners all on one line are NotConvex.
enum class PolygonShape { Convex, NotPlanar, NotConvex };

/// A positive multiple of the plane of a polygon: through its first corner, the first one that differs from
/// it, and the first one off their line. Requires a corner, and equal ones to be written in the same way, as
/// `weighted` does.
/// (1) Of planar corners all lie in it.
/// (2) Its normal is zero exactly where all corners lie on one line.
/// (3) Its normal points to where a convex polygon goes counterclockwise.
template <class Scalar> [[nodiscard]] Plane<Scalar> planeOf(std::span<const WeightedPoint<Scalar>> corners) {
  const WeightedPoint<Scalar> &first = corners.front();
  std::size_t second = 1;
  while (second < corners.size() && corners[second] == first)
    ++second;
  for (std::size_t third = second + 1; third < corners.size(); ++third)
    if (auto plane = planeThrough(first, corners[second], corners[third]); !isZero(plane.normal))
      return plane;
  return {};
}

/// Whether corners that lie in a plane are those of a strictly convex polygon that goes counterclockwise
/// around its normal ≠ 0: each turn goes to the left, and all together go round once.
template <class Scalar>
[[nodiscard]] bool goesRoundConvexly(std::span<const WeightedPoint<Scalar>> corners,
                                     const Vec3<Scalar> &normal) {
  const Scalar zero(0);
  // Looked at along an axis that is not parallel to the plane, as two coordinates, from the side on which
  // left is left.
  struct Direction {
    Scalar x;
    Scalar y;
  };
  const glm::length_t axis = normal.x != zero ? 0 : normal.y != zero ? 1 : 2;
  glm::length_t xAxis = (axis + 1) % 3;
  glm::length_t yAxis = (axis + 2) % 3;
  if (normal[axis] < zero)
    std::swap(xAxis, yAxis);
  const auto edge = [&](std::size_t i) -> Direction {
    const auto &from = corners[i];
    const auto &to = corners[(i + 1) % corners.size()];
    return {to.position[xAxis] * from.weight - from.position[xAxis] * to.weight,
            to.position[yAxis] * from.weight - from.position[yAxis] * to.weight};
  };
  const auto turn = [](const Direction &from, const Direction &to) -> Scalar {
    return from.x * to.y - from.y * to.x;
  };
  // Edges whose direction lies less than half a turn from the first one's, and those in the other half: a
  // polygon that goes round once comes back from the other half once.
  const Direction reference = edge(0);
  const auto inFirstHalf = [&](const Direction &direction) {
    const Scalar side = turn(reference, direction);
    return side == zero ? reference.x * direction.x + reference.y * direction.y > zero : side > zero;
  };
  int rounds = 0;
  Direction before = edge(corners.size() - 1);
  bool wasInFirstHalf = inFirstHalf(before);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Direction direction = edge(i);
    if (turn(before, direction) <= zero)
      return false;
    const bool isInFirstHalf = inFirstHalf(direction);
    if (isInFirstHalf && !wasInFirstHalf)
      ++rounds;
    before = direction;
    wasInFirstHalf = isInFirstHalf;
  }
  return rounds == 1;
}

/// Whether the corners are those of a strictly convex polygon, in time linear in their number. Requires a
/// corner, and equal ones to be written in the same way, as `weighted` does.
/// (1) The same whichever corner comes first and whichever way round they go.
/// (2) Of three corners: Convex where the triangle is Proper, else NotConvex.
/// (3) Convex exactly where from each edge all other corners lie on one side, none on its line, in a plane.
template <class Scalar> [[nodiscard]] PolygonShape shapeOf(std::span<const WeightedPoint<Scalar>> corners) {
  const Plane<Scalar> plane = planeOf(corners);
  for (const WeightedPoint<Scalar> &corner : corners)
    if (evaluate(plane, corner) != Scalar(0))
      return PolygonShape::NotPlanar;
  return !isZero(plane.normal) && goesRoundConvexly(corners, plane.normal) ? PolygonShape::Convex
                                                                           : PolygonShape::NotConvex;
}
template <class Scalar> [[nodiscard]] PolygonShape shapeOf(const Polygon<Scalar> &corners) {
  return shapeOf(std::span<const WeightedPoint<Scalar>>(weighted(corners)));
}

} // namespace halfspace
