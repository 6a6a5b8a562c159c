// The area of a polygon, by the cross products of a fan of triangles.
#pragma once

#include "geometry/polygon.h"
#include "geometry/surd.h"

#include <algorithm>

namespace halfspace {

/// Simple: the boundary does not meet itself, though it may bend inwards. SelfMeeting: it touches or crosses
/// itself. Both of corners in one plane.
enum class PolygonAreaCase { Simple, SelfMeeting, OnOneLine, NotPlanar };

/// The area of a polygon, with every number on the way.
template <class Scalar> struct PolygonArea {
  PolygonAreaCase which = PolygonAreaCase::OnOneLine;
  std::vector<Vec3<Scalar>> fan{}; ///< (Pᵢ − P₀)×(Pᵢ₊₁ − P₀), for the corners between P₀ and the last
  Vec3<Scalar> sum{};              ///< of them; twice as long as the area
  Root<Scalar> area{};             ///< |sum|/2; not set for NotPlanar
};

/// Two coordinates of a point, for turns in a plane.
template <class Scalar> struct FlatPoint {
  Scalar x;
  Scalar y;
  bool operator==(const FlatPoint &) const = default;
};

/// Positive where the way from a by b to c turns to one side, negative for the other, 0 on a line.
/// (1) The opposite for c, b, a.
template <class Scalar>
[[nodiscard]] Scalar turnOf(const FlatPoint<Scalar> &a, const FlatPoint<Scalar> &b,
                            const FlatPoint<Scalar> &c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Whether a point of the line through a and b lies between them, or is one of them.
template <class Scalar>
[[nodiscard]] bool isBetween(const FlatPoint<Scalar> &point, const FlatPoint<Scalar> &a,
                             const FlatPoint<Scalar> &b) {
  return std::min(a.x, b.x) <= point.x && point.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= point.y &&
         point.y <= std::max(a.y, b.y);
}

/// Whether two segments of a plane have a point in common.
/// (1) The same with the segments, or the ends of one, exchanged.
template <class Scalar>
[[nodiscard]] bool haveCommonPoint(const FlatPoint<Scalar> &a, const FlatPoint<Scalar> &b,
                                   const FlatPoint<Scalar> &c, const FlatPoint<Scalar> &d) {
  const Scalar zero(0);
  const auto side = [&](const Scalar &turn) { return turn > zero ? 1 : turn < zero ? -1 : 0; };
  const int ofC = side(turnOf(a, b, c));
  const int ofD = side(turnOf(a, b, d));
  const int ofA = side(turnOf(c, d, a));
  const int ofB = side(turnOf(c, d, b));
  if (ofC * ofD < 0 && ofA * ofB < 0)
    return true;
  return (ofC == 0 && isBetween(c, a, b)) || (ofD == 0 && isBetween(d, a, b)) ||
         (ofA == 0 && isBetween(a, c, d)) || (ofB == 0 && isBetween(b, c, d));
}

/// Whether the boundary of corners in a plane touches or crosses itself: two sides that are no neighbours
/// have a common point, or one goes back along its neighbour. Corners that follow each other in one place
/// count once. Requires three corners not on one line, and a normal ≠ 0 of their plane. (1) The same
/// whichever corner comes first and whichever way round they go. (2) Never of a strictly convex polygon.
template <class Scalar>
[[nodiscard]] bool meetsItself(const std::vector<Vec3<Scalar>> &corners, const Vec3<Scalar> &normal) {
  const Scalar zero(0);
  const glm::length_t axis = normal.x != zero ? 0 : normal.y != zero ? 1 : 2;
  std::vector<FlatPoint<Scalar>> points;
  for (const Vec3<Scalar> &corner : corners)
    if (FlatPoint<Scalar> point{corner[(axis + 1) % 3], corner[(axis + 2) % 3]};
        points.empty() || !(points.back() == point))
      points.push_back(std::move(point));
  while (points.size() > 1 && points.back() == points.front())
    points.pop_back();
  const std::size_t count = points.size();
  const auto at = [&](std::size_t i) -> const FlatPoint<Scalar> & { return points[i % count]; };
  for (std::size_t i = 0; i < count; ++i) {
    if (turnOf(at(i), at(i + 1), at(i + 2)) == zero && !isBetween(at(i + 1), at(i), at(i + 2)))
      return true;
    for (std::size_t k = i + 2; k < count && k + 1 < i + count; ++k)
      if (haveCommonPoint(at(i), at(i + 1), at(k), at(k + 1)))
        return true;
  }
  return false;
}

/// The area of a polygon. Of SelfMeeting each part counts as often as the boundary goes round it, and
/// negative where it goes round the other way. Requires at least three corners. (1) The sum is the same
/// whichever corner comes first, and turned round for the corners the other way round. (2) Moved corners have
/// the same fan; those k times as large, k² times the sum. (3) The sum is perpendicular to the plane of the
/// corners, and 0 for OnOneLine. (4) For Simple the area is that of all triangles that the polygon is cut
/// into.
template <class Scalar> [[nodiscard]] PolygonArea<Scalar> polygonArea(const Polygon<Scalar> &corners) {
  const Scalar zero(0);
  PolygonArea<Scalar> result;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    result.fan.push_back(
        cross(Vec3<Scalar>(corners[i] - corners[0]), Vec3<Scalar>(corners[i + 1] - corners[0])));
    result.sum += result.fan.back();
  }
  const auto points = weighted(corners);
  const auto plane = planeOf(std::span<const WeightedPoint<Scalar>>(points));
  const bool isPlanar = std::all_of(points.begin(), points.end(),
                                    [&](const auto &point) { return evaluate(plane, point) == zero; });
  if (!isPlanar) {
    result.which = PolygonAreaCase::NotPlanar;
    return result;
  }
  result.area = timesRoot(Scalar(Scalar(1) / Scalar(2)), dot(result.sum, result.sum));
  if (!isZero(plane.normal))
    result.which =
        meetsItself(corners, plane.normal) ? PolygonAreaCase::SelfMeeting : PolygonAreaCase::Simple;
  return result;
}

} // namespace halfspace
