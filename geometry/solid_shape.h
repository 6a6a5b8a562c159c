// Whether a mesh is a convex solid.
#pragma once

#include "geometry/polygon.h"
#include "geometry/solid.h"
#include "geometry/vertex_tree.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace halfspace {

/// Convex: every face is a convex polygon, no vertex lies in front of a face and some vertex lies behind it;
/// two faces may share a plane. NotClosed: the edge i→j of some face is not the edge j→i of exactly one other
/// face.
enum class SolidShape { Convex, NotPlanar, NotConvex, NotClosed };

/// The corners of faces, and the faces' edges as `edgesByEnds` gives them.
template <class Scalar> struct FaceSet {
  std::vector<WeightedPoint<Scalar>> vertices;
  const std::vector<std::vector<std::uint32_t>> &faces;
  std::vector<FaceEdge> edges;
};

/// Whether a point lies inside a tetrahedron, not on its surface. Requires corners that do not all lie in one
/// plane.
/// (1) The same for the corners in any order.
template <class Scalar>
[[nodiscard]] bool isInside(const WeightedPoint<Scalar> &point,
                            const std::array<WeightedPoint<Scalar>, 4> &corners) {
  const Scalar zero(0);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto opposite = planeThrough(corners[(i + 1) % 4], corners[(i + 2) % 4], corners[(i + 3) % 4]);
    const Scalar side = evaluate(opposite, point);
    if (side == zero || (side > zero) != (evaluate(opposite, corners[i]) > zero))
      return false;
  }
  return true;
}

/// A point inside the hull of the vertices, not on its surface; nothing where all lie in the first face's
/// plane. Requires a convex polygon as that face.
template <class Scalar>
[[nodiscard]] std::optional<WeightedPoint<Scalar>> pointWithin(const FaceSet<Scalar> &set) {
  const auto &face = set.faces.front();
  const Plane<Scalar> plane = planeOf(face, set.vertices);
  const auto apex = std::find_if(set.vertices.begin(), set.vertices.end(),
                                 [&](const auto &vertex) { return evaluate(plane, vertex) != Scalar(0); });
  if (apex == set.vertices.end())
    return {};
  const std::array corners{set.vertices[face[0]], set.vertices[face[1]], set.vertices[face[2]], *apex};
  const auto mean = meanOf({corners[0], corners[1], corners[2], corners[3]});
  const auto near = rounded(mean);
  return isInside(near, corners) ? near : mean;
}

/// Whether closed faces go round a point once: a half-line from there leaves through one face. The point lies
/// behind all of them.
template <class Scalar>
[[nodiscard]] bool goRoundOnce(const FaceSet<Scalar> &set, const WeightedPoint<Scalar> &point) {
  const auto solid = solidOf(set.vertices, set.faces);
  const auto isOnlyFaceTowards = [&](const WeightedPoint<Scalar> &target) {
    const Line<Scalar> line = lineThrough(point, target);
    const auto products = productsWith(line, solid);
    return 1 == std::count_if(solid.faces.begin(), solid.faces.end(), [&](const auto &face) {
             return dot(line.direction, face.plane.normal) > Scalar(0) &&
                    crossesFace<Scalar>(face, products, true);
           });
  };
  const auto &face = set.faces.front();
  const auto target = meanOf({set.vertices[face[0]], set.vertices[face[1]], set.vertices[face[2]]});
  // Nearly always the rounded target does; of tiny faces it may hit an edge, which belongs to two of them.
  return isOnlyFaceTowards(rounded(target)) || isOnlyFaceTowards(target);
}

/// The planes of faces, which are to be behind each other.
template <class Scalar> struct FacePlanes {
  std::vector<Plane<Scalar>> planes;
  std::vector<bool> isRepeated; ///< whether a face of lower index has the same plane: of neighbours alone
};

/// Looks at faces that share an edge, each against one corner of the other; nothing where it lies in front.
/// Some point lies behind all planes.
template <class Scalar>
[[nodiscard]] std::optional<FacePlanes<Scalar>> bentBackwards(const FaceSet<Scalar> &set,
                                                              std::vector<Plane<Scalar>> planes) {
  std::vector<bool> isRepeated(planes.size());
  for (std::size_t i = 0; i + 1 < set.edges.size(); ++i) {
    const FaceEdge &edge = set.edges[i];
    const FaceEdge &next = set.edges[i + 1];
    if (edge.ends() != next.ends())
      continue;
    const auto &corners = set.faces[next.face];
    const auto third = std::find_if(corners.begin(), corners.end(), [&](std::uint32_t corner) {
      return corner != edge.from && corner != edge.to;
    });
    const Scalar side = evaluate(planes[edge.face], set.vertices[*third]);
    if (side > Scalar(0))
      return {};
    isRepeated[next.face] = isRepeated[next.face] || side == Scalar(0);
  }
  return FacePlanes<Scalar>{std::move(planes), std::move(isRepeated)};
}

/// The vertices of no face.
template <class Scalar>
[[nodiscard]] std::vector<WeightedPoint<Scalar>> looseVertices(const FaceSet<Scalar> &set) {
  std::vector<bool> isUsed(set.vertices.size());
  for (const auto &face : set.faces)
    for (const std::uint32_t corner : face)
      isUsed[corner] = true;
  std::vector<WeightedPoint<Scalar>> loose;
  for (std::size_t i = 0; i < isUsed.size(); ++i)
    if (!isUsed[i])
      loose.push_back(set.vertices[i]);
  return loose;
}

/// Whether no vertex lies in front of a face and some vertex lies behind each: by looking at all.
template <class Scalar>
[[nodiscard]] bool areAllBehindOneByOne(const FaceSet<Scalar> &set,
                                        const std::vector<Plane<Scalar>> &planes) {
  const Scalar zero(0);
  return std::all_of(planes.begin(), planes.end(), [&](const Plane<Scalar> &plane) {
    bool someBehind = false;
    for (const WeightedPoint<Scalar> &vertex : set.vertices) {
      const Scalar side = evaluate(plane, vertex);
      if (side > zero)
        return false;
      someBehind = someBehind || side < zero;
    }
    return someBehind;
  });
}

/// Whether no vertex lies in front of a face and some vertex lies behind each. Requires faces that are convex
/// polygons.
/// (1) The answer of `areAllBehindOneByOne` with the faces' planes, which takes longer.
///
/// Closed faces that all bend backwards at their edges, behind which one point lies, and that go round it
/// once, are the surface of a convex body (Mehlhorn and others, Checking geometric programs or verification
/// of geometric structures, 1999): that takes a few signs for each edge. Only what is no such surface, and
/// vertices of no face, are held against all faces.
template <class Scalar> [[nodiscard]] bool areAllBehind(const FaceSet<Scalar> &set) {
  constexpr std::size_t few = 16; // so many are looked at in less time than all the preparation takes
  std::vector<Plane<Scalar>> planes;
  planes.reserve(set.faces.size());
  for (const auto &face : set.faces)
    planes.push_back(planeOf(face, set.vertices));
  if (set.vertices.size() <= few && set.faces.size() <= 2 * few)
    return areAllBehindOneByOne(set, planes);

  // Where no vertex lies in front of a plane, all points inside the hull lie behind it, or all vertices in
  // it.
  const auto center = pointWithin(set);
  if (!center || std::any_of(planes.begin(), planes.end(), [&](const Plane<Scalar> &plane) {
        return evaluate(plane, *center) >= Scalar(0);
      }))
    return false;
  const auto bent = bentBackwards(set, std::move(planes));
  if (!bent)
    return false;
  const bool isSurface = isClosed(set.edges) && goRoundOnce(set, *center);
  const auto open = isSurface ? looseVertices(set) : set.vertices;
  if (open.empty())
    return true;
  const VertexTree<Scalar> tree(open);
  for (std::size_t i = 0; i < bent->planes.size(); ++i)
    if (!bent->isRepeated[i] && tree.hasInFront(bent->planes[i]))
      return false;
  return true;
}

/// The first of NotPlanar, NotConvex and NotClosed that holds of a mesh, else Convex. The time is linear in
/// the number of corners for a closed solid whose vertices are all in faces. Else boxes and doubles keep it
/// near to that; where doubles do not tell the points apart, it grows with the product of vertices and faces.
/// Requires faces of at least three vertices.
/// (1) The same for the faces and the vertices in any order and for any first corner of a face.
/// (2) A mesh inside out, every face turned over, is NotConvex where it was Convex.
template <class Scalar> [[nodiscard]] SolidShape shapeOf(const SolidMesh<Scalar> &mesh) {
  const FaceSet<Scalar> set{weighted(mesh.vertices), mesh.faces, edgesByEnds(mesh.faces)};
  bool convex = true;
  for (const auto &face : mesh.faces) {
    std::vector<WeightedPoint<Scalar>> corners;
    corners.reserve(face.size());
    for (const std::uint32_t index : face)
      corners.push_back(set.vertices[index]);
    const PolygonShape shape = shapeOf(std::span<const WeightedPoint<Scalar>>(corners));
    if (shape == PolygonShape::NotPlanar)
      return SolidShape::NotPlanar;
    convex = convex && shape == PolygonShape::Convex;
  }
  if (!convex || !areAllBehind(set))
    return SolidShape::NotConvex;
  return isClosed(set.edges) ? SolidShape::Convex : SolidShape::NotClosed;
}

} // namespace halfspace
