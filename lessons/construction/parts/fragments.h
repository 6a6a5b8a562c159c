// The triangles of several meshes, as one list.
#pragma once

#include "geometry/intersect_ray_triangle.h"
#include "lessons/object/kinds/mesh.h"
#include "lessons/object/kinds/ray.h"

#include <optional>
#include <vector>

namespace halfspace {

using GivenMeshes = std::vector<Given<MeshObject>>;

/// A triangle among those of several meshes.
struct Fragment {
  std::size_t mesh = 0;  ///< its place in the list
  std::size_t index = 0; ///< among the triangles of that mesh
  bool operator==(const Fragment &) const = default;
};

/// Triangles are numbered from 1 through all meshes, in their order.
[[nodiscard]] std::size_t fragmentCount(const GivenMeshes &meshes);
[[nodiscard]] std::size_t numberOf(const GivenMeshes &meshes, const Fragment &fragment);
/// Requires a number from 1 to the count.
[[nodiscard]] Fragment fragmentOf(const GivenMeshes &meshes, std::size_t number);

[[nodiscard]] Triangle<Rational> triangleOf(const GivenMeshes &meshes, const Fragment &fragment);
/// In plain words, counted within its mesh: barn 3.
[[nodiscard]] std::string nameOf(const GivenMeshes &meshes, const Fragment &fragment);

/// The parameter at which a ray crosses a triangle's plane, by the triangle's numbers: it has no letters.
[[nodiscard]] Term crossingTerm(const RayTerms &ray, const Triangle<Rational> &triangle);

/// What a ray hits first.
struct FirstHits {
  std::vector<Fragment> fragments; ///< of each mesh that is hit at that t the first; none without a hit
  Rational t;
};

/// Requires a direction ≠ 0. Of triangles of one mesh that are hit at the same t the first counts.
[[nodiscard]] FirstHits firstHits(const RayObject &ray, const GivenMeshes &meshes);

} // namespace halfspace
