// Convex solids.
#pragma once

#include "geometry/weighted_point.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace halfspace {

/// The boundary of a solid as it is given: each face is a list of at least three indices of vertices,
/// counterclockwise seen from outside.
template <class Scalar> struct SolidMesh {
  std::vector<Vec3<Scalar>> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// A convex solid that can be asked. Each edge is shared by two faces and held once, so that one product with
/// it serves both (note PL). Planes and lines are positive multiples of those of the vertices, over fractions
/// in whole numbers.
template <class Scalar> struct ConvexSolid {
  /// An edge as a face has it: in the direction of its line, or against it.
  struct Side {
    std::uint32_t edge;
    bool forward;
  };
  struct Face {
    Plane<Scalar> plane; ///< the normal points outwards
    std::vector<Side> sides;
  };
  std::vector<Line<Scalar>> edges;
  std::vector<Face> faces;
};

/// An edge of a face by its vertices' indices.
struct FaceEdge {
  std::uint32_t from;
  std::uint32_t to;
  std::uint32_t face;

  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> ends() const { return std::minmax(from, to); }
};

/// All edges of all faces, in the order of their ends and then of their faces: those between the same two
/// vertices stand together.
[[nodiscard]] std::vector<FaceEdge> edgesByEnds(const std::vector<std::vector<std::uint32_t>> &faces);

/// Whether each edge is had by two faces, in opposite directions. Requires the order of `edgesByEnds`.
[[nodiscard]] bool isClosed(const std::vector<FaceEdge> &edgesByEnds);

/// A positive multiple of the plane of a face: its normal points to where the face is counterclockwise.
/// Requires a convex one.
template <class Scalar>
[[nodiscard]] Plane<Scalar> planeOf(const std::vector<std::uint32_t> &face,
                                    const std::vector<WeightedPoint<Scalar>> &vertices) {
  return planeThrough(vertices[face[0]], vertices[face[1]], vertices[face[2]]);
}

/// The solid of vertices and faces. Requires that their shape is Convex.
/// (1) Each edge is held once and is a side of two faces, of one forward and of one backward.
/// (2) No vertex lies in front of a face's plane, and the face's own lie in it.
/// (3) Planes and lines are k·those of the mesh, each with some k > 0; over fractions all their numbers are
///     whole.
template <class Scalar>
[[nodiscard]] ConvexSolid<Scalar> solidOf(const std::vector<WeightedPoint<Scalar>> &vertices,
                                          const std::vector<std::vector<std::uint32_t>> &faces) {
  ConvexSolid<Scalar> solid;
  for (const auto &face : faces)
    solid.faces.push_back({planeOf(face, vertices), {}});
  std::optional<std::pair<std::uint32_t, std::uint32_t>> ends;
  bool forward = true;
  for (const FaceEdge &edge : edgesByEnds(faces)) {
    forward = ends != edge.ends();
    if (forward) {
      ends = edge.ends();
      solid.edges.push_back(lineThrough(vertices[edge.from], vertices[edge.to]));
    }
    solid.faces[edge.face].sides.push_back({static_cast<std::uint32_t>(solid.edges.size() - 1), forward});
  }
  return solid;
}
template <class Scalar> [[nodiscard]] ConvexSolid<Scalar> solidOf(const SolidMesh<Scalar> &mesh) {
  return solidOf(weighted(mesh.vertices), mesh.faces);
}

/// The products of a line with all edges of a solid (note PL).
template <class Scalar>
[[nodiscard]] std::vector<Scalar> productsWith(const Line<Scalar> &line, const ConvexSolid<Scalar> &solid) {
  std::vector<Scalar> products;
  products.reserve(solid.edges.size());
  for (const Line<Scalar> &edge : solid.edges)
    products.push_back(permutedInnerProduct(line, edge));
  return products;
}

/// Whether a line crosses a face (its boundary included), by its products with all edges of the solid and the
/// sign of direction·normal ≠ 0: those with the face's own edges, as the face has them, all have that sign or
/// are 0.
/// (1) Negative products with the other sign, which are those of the line turned round, give the same.
template <class Scalar>
[[nodiscard]] bool crossesFace(const typename ConvexSolid<Scalar>::Face &face,
                               const std::vector<Scalar> &products, bool withNormal) {
  const Scalar zero(0);
  return std::all_of(face.sides.begin(), face.sides.end(), [&](const auto &side) {
    const Scalar &product = products[side.edge];
    return product == zero || (product > zero) == (side.forward == withNormal);
  });
}

} // namespace halfspace
