// Convex solids.
#pragma once

#include "geometry/line.h"
#include "geometry/polygon.h"
#include "geometry/vertex_tree.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace halfspace {

/// The boundary of a solid as it is given: each face is a list of at least three indices of vertices,
/// counterclockwise seen from outside.
template <class Scalar> struct SolidMesh {
  std::vector<Vec3<Scalar>> vertices;
  std::vector<std::vector<std::uint32_t>> faces;

  [[nodiscard]] Polygon<Scalar> corners(const std::vector<std::uint32_t> &face) const {
    Polygon<Scalar> corners;
    for (const std::uint32_t index : face)
      corners.push_back(vertices[index]);
    return corners;
  }

  /// Of a convex face: its normal points to where the face is counterclockwise.
  [[nodiscard]] Plane<Scalar> planeOf(const std::vector<std::uint32_t> &face) const {
    return planeThrough(vertices[face[0]], vertices[face[1]], vertices[face[2]]);
  }
};

/// Convex: every face is a convex polygon, no vertex lies in front of a face and some vertex lies behind it;
/// two faces may share a plane. NotClosed: the edge i→j of some face is not the edge j→i of exactly one other
/// face.
enum class SolidShape { Convex, NotPlanar, NotConvex, NotClosed };

/// A convex solid that can be asked. Each edge is shared by two faces and held once, so that one product with
/// it serves both (note PL).
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

/// All edges of all faces; those between the same two vertices stand together.
[[nodiscard]] std::vector<FaceEdge> edgesByEnds(const std::vector<std::vector<std::uint32_t>> &faces);

/// Whether each edge is had by two faces, in opposite directions.
[[nodiscard]] bool isClosed(const std::vector<FaceEdge> &edgesByEnds);

/// The first of NotPlanar, NotConvex and NotClosed that holds of a mesh, else Convex.
template <class Scalar> [[nodiscard]] SolidShape shapeOf(const SolidMesh<Scalar> &mesh) {
  bool convex = true;
  for (const auto &face : mesh.faces) {
    const PolygonShape shape = shapeOf(std::span<const Vec3<Scalar>>(mesh.corners(face)));
    if (shape == PolygonShape::NotPlanar)
      return SolidShape::NotPlanar;
    convex = convex && shape == PolygonShape::Convex;
  }
  const VertexTree<Scalar> vertices(mesh.vertices);
  for (auto face = mesh.faces.begin(); convex && face != mesh.faces.end(); ++face) {
    const Plane<Scalar> plane = mesh.planeOf(*face);
    const Plane<Scalar> turned{-plane.normal, Scalar(-plane.offset)};
    convex = !vertices.hasInFront(plane) && vertices.hasInFront(turned);
  }
  if (!convex)
    return SolidShape::NotConvex;
  return isClosed(edgesByEnds(mesh.faces)) ? SolidShape::Convex : SolidShape::NotClosed;
}

/// The solid of a mesh whose shape is Convex.
template <class Scalar> [[nodiscard]] ConvexSolid<Scalar> solidOf(const SolidMesh<Scalar> &mesh) {
  ConvexSolid<Scalar> solid;
  for (const auto &face : mesh.faces)
    solid.faces.push_back({mesh.planeOf(face), {}});
  std::optional<std::pair<std::uint32_t, std::uint32_t>> ends;
  bool forward = true;
  for (const FaceEdge &edge : edgesByEnds(mesh.faces)) {
    forward = ends != edge.ends();
    if (forward) {
      ends = edge.ends();
      solid.edges.push_back(lineThrough(mesh.vertices[edge.from], mesh.vertices[edge.to]));
    }
    solid.faces[edge.face].sides.push_back({static_cast<std::uint32_t>(solid.edges.size() - 1), forward});
  }
  return solid;
}

} // namespace halfspace
