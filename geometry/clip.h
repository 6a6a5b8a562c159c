// Where a plane cuts an edge, and what it leaves of a polygon: the part on its positive side, with the plane
// itself.
#pragma once

#include "geometry/plane.h"

#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

namespace halfspace {

/// How an edge stands to the half-space that is kept, from its start to its end. A point of the plane is
/// kept.
enum class EdgeCase { Kept, Leaves, Outside, Enters };

/// An edge at a plane.
template <class Scalar> struct EdgeClip {
  EdgeCase which = EdgeCase::Outside;
  /// Whether the plane goes through it between its ends: f has one sign at its start, the other at its end.
  bool isCut = false;
  Scalar t{};           ///< the part of the edge, from its start, up to the plane; 0 where it is not cut
  Vec3<Scalar> point{}; ///< from + t·(to − from); zero where it is not cut
};

/// Clips the edge between two points by what f comes to at them, which changes evenly along it: from f(from)
/// to 0 is f(from)/(f(from) − f(to)) of the way.
/// (1) Where it is cut, 0 < t < 1 and f(point) = 0: exactly, over rationals.
/// (2) k·f instead of f, k > 0, gives the same, whatever the length of the normal.
/// (3) The edge the other way round is cut at the same point, over doubles too: neighbours share it. Then t
///     is 1 − t, and Leaves and Enters change places.
/// (4) An end in the plane is no cut.
template <class Scalar>
[[nodiscard]] EdgeClip<Scalar> clipEdge(const Vec3<Scalar> &from, const Scalar &atFrom,
                                        const Vec3<Scalar> &to, const Scalar &atTo) {
  const Scalar zero(0);
  const bool isStartKept = atFrom >= zero;
  const bool isEndKept = atTo >= zero;
  EdgeClip<Scalar> clip;
  if (isStartKept == isEndKept) {
    clip.which = isStartKept ? EdgeCase::Kept : EdgeCase::Outside;
    return clip;
  }
  clip.which = isStartKept ? EdgeCase::Leaves : EdgeCase::Enters;
  clip.isCut = atFrom != zero && atTo != zero;
  if (!clip.isCut)
    return clip;
  clip.t = atFrom / (atFrom - atTo);
  // always from the end that is kept, so that the direction of the edge does not matter to the last digit
  const Vec3<Scalar> &kept = isStartKept ? from : to;
  const Vec3<Scalar> &lost = isStartKept ? to : from;
  const Scalar &atKept = isStartKept ? atFrom : atTo;
  const Scalar &atLost = isStartKept ? atTo : atFrom;
  clip.point = kept + (lost - kept) * Scalar(atKept / (atKept - atLost));
  return clip;
}

/// A corner of what is left of a polygon.
struct KeptCorner {
  std::size_t edge;
  bool isCut; ///< it is the edge's cut, else the edge's end
};

/// The corners of what is left of a convex polygon, by its edges one after the other (Sutherland and
/// Hodgman): around them once, each edge gives its cut, and its end where that is kept.
template <class Scalar>
[[nodiscard]] std::vector<KeptCorner> keptCorners(std::span<const EdgeClip<Scalar>> edges) {
  std::vector<KeptCorner> kept;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (edges[i].isCut)
      kept.push_back({i, true});
    if (edges[i].which == EdgeCase::Kept || edges[i].which == EdgeCase::Enters)
      kept.push_back({i, false});
  }
  return kept;
}

/// The edges of a polygon at a plane; edge i goes from corner i to the next one.
template <class Scalar>
[[nodiscard]] std::vector<EdgeClip<Scalar>> clipEdges(std::span<const Vec3<Scalar>> corners,
                                                      const Plane<Scalar> &plane) {
  std::vector<Scalar> f;
  f.reserve(corners.size());
  for (const Vec3<Scalar> &corner : corners)
    f.push_back(evaluate(plane, corner));
  std::vector<EdgeClip<Scalar>> edges;
  edges.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t next = (i + 1) % corners.size();
    edges.push_back(clipEdge(corners[i], f[i], corners[next], f[next]));
  }
  return edges;
}

/// The corners of the part of a convex polygon with f ≥ 0, in the order of `keptCorners`. Halfspace itself
/// takes that walk, because it names the corners; this is for programs that only want their places. None
/// where nothing is left; one or two where only a corner or an edge lies in the plane, which have no area.
/// Requires a normal ≠ 0.
/// (1) They go around the same way, and a point of the polygon is in what they go around exactly where f ≥ 0.
/// (2) They are strictly convex where the polygon is and more than two of them are left: none stands twice.
/// (3) At most one more than the polygon has; the same as it has, in their order, where all are kept.
/// (4) k·[n, d] instead of [n, d], k > 0, leaves the same.
/// (5) What is left is left wholly by the same plane once more.
/// (6) Unless it lies in the plane, it falls by [n, d] and by −[n, d] into two whose areas add up to its own.
/// (7) One plane after the other leaves what is in both half-spaces, in whatever order.
template <class Scalar>
[[nodiscard]] std::vector<Vec3<Scalar>> clipPolygon(std::span<const Vec3<Scalar>> corners,
                                                    const Plane<Scalar> &plane) {
  assert(!isZero(plane.normal));
  const std::vector<EdgeClip<Scalar>> edges = clipEdges(corners, plane);
  std::vector<Vec3<Scalar>> kept;
  for (const auto &[edge, isCut] : keptCorners<Scalar>(edges))
    kept.push_back(isCut ? edges[edge].point : corners[(edge + 1) % corners.size()]);
  return kept;
}

} // namespace halfspace
