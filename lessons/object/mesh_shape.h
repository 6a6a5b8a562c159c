// What meshes are made of: many triangles, never changed, and shared by all objects that have them.
#pragma once

#include "geometry/hit_search.h"
#include "lessons/reading/problem.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// The corners around a face, by their numbers.
using MeshFace = std::vector<std::uint32_t>;

/// The box around corners, along the axes.
struct MeshBox {
  Vec3<double> low{};
  Vec3<double> high{};
};

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
  /// As they were given; none where there are too many.
  [[nodiscard]] const std::vector<MeshFace> &faces() const { return m_faces; }
  /// Around all corners.
  [[nodiscard]] const MeshBox &box() const { return m_box; }
  [[nodiscard]] std::size_t triangleCount() const { return m_mesh->triangles.size(); }

  /// Whether they have the same corners and triangles.
  bool operator==(const MeshShape &other) const { return *m_mesh == *other.m_mesh; }

private:
  std::vector<MeshFace> m_faces;
  std::shared_ptr<const TriangleMesh> m_mesh;
  std::shared_ptr<const HitSearch> m_search;
  MeshBox m_box;
};

/// What corners and faces are called in files.
inline constexpr const char *cornersField = "corners";
inline constexpr const char *facesField = "faces";
/// A shape has at most so many faces in a file of ours.
inline constexpr std::size_t mostWrittenFaces = 200000;
/// A face has at most so many corners there.
inline constexpr std::size_t mostFaceCorners = 100;

/// Reads a shape as files have it: corners `0 0 0, 4 0 0, 0 3 0.5`, counted from 0, and faces by the numbers
/// of their corners, `0 1 2, 0 2 3 4`. A coordinate must be a double exactly: 0.5 and 0.375 are, 0.1 is not.
[[nodiscard]] Result<std::shared_ptr<const MeshShape>> readShape(std::string_view corners,
                                                                 std::string_view faces);
/// The same, written. Of triangles without faces each is a face.
struct WrittenShape {
  std::string corners;
  std::string faces;
};
[[nodiscard]] WrittenShape written(const MeshShape &shape);

} // namespace halfspace
