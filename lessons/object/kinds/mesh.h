// Meshes: many triangles, placed in space as one.
#pragma once

#include "geometry/ray.h"
#include "lessons/object/given.h"
#include "lessons/object/mesh_shape.h"

#include <glm/mat3x3.hpp>

namespace halfspace {

/// A shape, and where it stands in the scene: scaled, then turned about the vertical until what lay along the
/// x-axis points as the heading does, then moved.
struct MeshObject {
  static constexpr std::string_view kind = "mesh";
  static auto coordinatesOf(auto &self) { return std::tie(self.place, self.heading, self.scale); }

  ExactVec3 place{};
  ExactVec3 heading{1, 0, 0};
  Rational scale = 1;
  std::shared_ptr<const MeshShape> shape{};
  bool operator==(const MeshObject &) const = default;
};

/// The way from a mesh's own space to the scene, and back; exact.
/// (1) A ray and a triangle of the scene, both brought to the mesh's space, have the same t, s and tTriangle.
class MeshPlacement {
public:
  explicit MeshPlacement(const MeshObject &mesh);

  [[nodiscard]] ExactVec3 toScene(const ExactVec3 &corner) const;
  [[nodiscard]] Triangle<Rational> toScene(const Triangle<double> &own) const;
  [[nodiscard]] Ray<Rational> toMesh(const Ray<Rational> &ray) const;
  /// Columns: where the axes of the mesh's space lead.
  [[nodiscard]] glm::dmat3 axes() const;

private:
  [[nodiscard]] ExactVec3 turned(const ExactVec3 &vector, const Rational &sine) const;

  ExactVec3 m_place;
  Rational m_scale;
  Rational m_cosine = 1;
  Rational m_sine = 0;
};

/// No mesh is scaled down to less than this: it would be a point.
inline const Rational smallestScale(1, 1000000000);

/// The mark that a triangle of the mesh is drawn in: that of its face, or of the whole mesh.
[[nodiscard]] std::string markOf(const Given<MeshObject> &mesh, std::size_t triangle);

/// The corners of a triangle of the mesh, in the scene.
[[nodiscard]] Triangle<Rational> triangleOf(const MeshObject &mesh, std::size_t index);

} // namespace halfspace
