// Planar convex polygons.
#pragma once

#include "geometry/plane.h"

#include <span>
#include <vector>

namespace halfspace {

/// Corners in order around; at least three.
template <class Scalar> using Polygon = std::vector<Vec3<Scalar>>;

/// Convex is meant strictly: a repeated corner, a straight one and corners all on one line are NotConvex.
enum class PolygonShape { Convex, NotPlanar, NotConvex };

/// The plane of a polygon: through its first corner, the first one that differs from it, and the first one
/// off their line. Its normal is zero when all corners lie on one line.
template <class Scalar> [[nodiscard]] Plane<Scalar> planeOf(std::span<const Vec3<Scalar>> corners) {
  const Vec3<Scalar> &first = corners.front();
  std::size_t second = 1;
  while (second < corners.size() && corners[second] == first)
    ++second;
  for (std::size_t third = second + 1; third < corners.size(); ++third)
    if (auto plane = planeThrough(first, corners[second], corners[third]); !isZero(plane.normal))
      return plane;
  return {};
}

/// Whether the corners are those of a strictly convex polygon, in time linear in their number: each turn goes
/// the same way, and all together go round once.
template <class Scalar> [[nodiscard]] PolygonShape shapeOf(std::span<const Vec3<Scalar>> corners) {
  const Scalar zero(0);
  const Plane<Scalar> plane = planeOf(corners);
  for (const Vec3<Scalar> &corner : corners)
    if (evaluate(plane, corner) != zero)
      return PolygonShape::NotPlanar;
  if (isZero(plane.normal))
    return PolygonShape::NotConvex;

  const std::size_t count = corners.size();
  const auto edge = [&](std::size_t i) -> Vec3<Scalar> {
    return corners[(i + 1) % count] - corners[i % count];
  };
  const auto turn = [&](const Vec3<Scalar> &from, const Vec3<Scalar> &to) -> Scalar {
    return dot(cross(from, to), plane.normal);
  };
  // Edges whose direction lies less than half a turn from the first one's, and those in the other half: a
  // polygon that goes round once comes back from the other half once.
  const Vec3<Scalar> reference = edge(0);
  const auto inFirstHalf = [&](const Vec3<Scalar> &direction) {
    const Scalar side = turn(reference, direction);
    return side == zero ? dot(reference, direction) > zero : side > zero;
  };
  int rounds = 0;
  Vec3<Scalar> before = edge(count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3<Scalar> direction = edge(i);
    const Scalar bend = turn(before, direction);
    if (bend <= zero)
      return PolygonShape::NotConvex;
    if (inFirstHalf(direction) && !inFirstHalf(before))
      ++rounds;
    before = direction;
  }
  return rounds == 1 ? PolygonShape::Convex : PolygonShape::NotConvex;
}

} // namespace halfspace
