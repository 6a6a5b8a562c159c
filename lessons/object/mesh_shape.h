// What meshes are made of: many triangles, never changed, and shared by all objects that have them.
#pragma once

#include "geometry/bounding_box.h"
#include "geometry/search/hit_search.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace halfspace {

/// The corners around a face, by their numbers.
using MeshFace = std::vector<std::uint32_t>;

/// Shapes with more faces than this are drawn as one, without their edges.
inline constexpr std::size_t mostDrawnFaces = 200;

/// Triangles in a space of their own, in which a ray's first hit among them is found.
class MeshShape {
public:
  /// Of faces that are flat and convex, with three corners and more. They are cut into triangles from their
  /// first corner, in their order.
  MeshShape(std::vector<Vec3<double>> corners, std::vector<MeshFace> faces);
  /// Of triangles alone, too many to be faces each, and a way to search them. Requires at least one corner.
  MeshShape(TriangleMesh mesh, std::shared_ptr<const HitSearch> search);

  [[nodiscard]] const std::shared_ptr<const TriangleMesh> &mesh() const { return m_mesh; }
  [[nodiscard]] const std::shared_ptr<const HitSearch> &search() const { return m_search; }
  /// As they were given, to be drawn each; none where there are too many for that.
  [[nodiscard]] const std::vector<MeshFace> &faces() const { return m_faces; }
  /// Around all corners.
  [[nodiscard]] const BoundingBox &box() const { return m_box; }
  [[nodiscard]] std::size_t triangleCount() const { return m_mesh->triangles.size(); }

  /// Whether they have the same corners, triangles and faces.
  bool operator==(const MeshShape &other) const {
    return m_faces == other.m_faces && *m_mesh == *other.m_mesh;
  }

private:
  std::vector<MeshFace> m_faces;
  std::shared_ptr<const TriangleMesh> m_mesh;
  std::shared_ptr<const HitSearch> m_search;
  BoundingBox m_box;
};

} // namespace halfspace
