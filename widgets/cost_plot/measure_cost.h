// What it costs to find the nearest hit among ever more triangles.
#pragma once

#include "geometry/search/hit_search.h"
#include "lessons/object/kinds/mesh.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <vector>

namespace halfspace {

/// A ray, and the meshes that it is shot at.
struct Aim {
  Ray<Rational> ray;
  std::vector<MeshObject> meshes;
  [[nodiscard]] bool operator==(const Aim &other) const;
};

/// What the same shot costs among so many triangles: asked one after the other, and by a tree of boxes.
struct CostPoint {
  std::size_t triangles = 0;
  SearchCost plain;
  SearchCost tree;
  double plainMicroseconds = 0;
  double treeMicroseconds = 0;
  bool inScene = false; ///< at the meshes themselves
};

/// Is told a cost as soon as it is measured.
using TellCost = std::function<void(const CostPoint &)>;

inline constexpr std::size_t fewestMeasured = 100;
inline constexpr std::size_t mostMeasured = 1'000'000;

/// A square field around the origin: bumps to both sides of z = 0, low ones, and always the same.
[[nodiscard]] TriangleMesh bumpyField(std::size_t triangles);

/// The shot as it is fired at the field: moved so that it comes down to z = 0 at the origin, or, where it
/// never does, starts above or below it; its numbers are rounded to doubles. Requires a direction ≠ 0.
[[nodiscard]] Ray<Rational> shotAtField(const Ray<Rational> &ray);

/// All triangles of meshes as they stand in the scene, in doubles.
[[nodiscard]] TriangleMesh oneMeshOf(const std::vector<MeshObject> &meshes);

/// Fires a shot at the meshes it aims at, if they have no more than `most` triangles, and then at ever larger
/// fields, until `cancelled`. The times are the best of several searches.
/// Requires a direction ≠ 0.
void measureCost(const Aim &aim, const std::atomic<bool> &cancelled, const TellCost &tell,
                 std::size_t most = mostMeasured);

} // namespace halfspace
