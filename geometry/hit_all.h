// The first of many triangles that a ray hits.
#pragma once

#include "geometry/intersect_ray_triangle.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <span>
#include <vector>

namespace halfspace {

/// A triangle that a ray hits, by its index, and where.
template <class Scalar> struct TriangleHit {
  std::size_t index = 0;
  Scalar t{};
  Vec3<Scalar> point{};
};

/// All hits of a ray among many triangles.
template <class Scalar> struct TriangleHits {
  std::vector<TriangleHit<Scalar>> hits; ///< by t ≥ 0, then by index: the first one is the nearest
  std::vector<std::size_t> skipped;      ///< degenerate triangles, and those whose plane the ray lies in
};

/// Intersects a ray with each of many triangles (note PG 7: the nearest fragment is the one with the smallest
/// parameter). Requires a direction ≠ 0.
/// (1) A triangle is among the hits, with its t and point, exactly where `intersectRayTriangle` says Hit.
/// (2) The hits ascend by t, those of the same t by index.
/// (3) The skipped ones ascend by index, and none of them is a hit.
template <class Scalar>
[[nodiscard]] TriangleHits<Scalar> hitAll(const Ray<Scalar> &ray,
                                          std::span<const Triangle<Scalar>> triangles) {
  assert(!isZero(ray.direction));
  TriangleHits<Scalar> result;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const RayTriangle<Scalar> meet = intersectRayTriangle(ray, triangles[i]);
    switch (meet.which) {
    case RayTriangleCase::Hit:
      result.hits.push_back({i, meet.plane.t, meet.plane.point});
      break;
    case RayTriangleCase::InPlane:
    case RayTriangleCase::Coincident:
    case RayTriangleCase::Collinear:
      result.skipped.push_back(i);
      break;
    default:
      break;
    }
  }
  std::stable_sort(result.hits.begin(), result.hits.end(),
                   [](const auto &a, const auto &b) { return a.t < b.t; });
  return result;
}

} // namespace halfspace
