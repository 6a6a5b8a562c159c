// The first of a mesh's triangles that a ray hits, and what it costs to find it.
#pragma once

#include "geometry/ray.h"
#include "geometry/triangle_mesh.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace halfspace {

/// What was looked at until the nearest hit was known.
struct SearchCost {
  std::size_t boxes = 0;
  std::size_t triangles = 0;

  bool operator==(const SearchCost &) const = default;
};

/// The most that the t of a hit in doubles is off, as a share of it, unless it is the nearest double.
inline constexpr double hitPrecision = 0x1p-36;

/// The triangle with the smallest t ≥ 0, of several the one with the lowest index.
struct NearestHit {
  std::size_t index = 0;
  double t = 0; ///< +infinity beyond the range of doubles
};

/// The same, with its t as the fraction that it is.
struct ExactNearestHit {
  std::size_t index = 0;
  Rational t;
  bool operator==(const ExactNearestHit &) const = default;
};

struct SearchResult {
  std::optional<ExactNearestHit> nearest;
  SearchCost cost;
};

/// Finds the first of many triangles that a ray hits, exactly.
/// (1) The answer is that of `hitAll` over fractions, whatever the way of searching.
class HitSearch {
public:
  HitSearch() = default;
  HitSearch(const HitSearch &) = delete;
  HitSearch &operator=(const HitSearch &) = delete;
  virtual ~HitSearch() = default;

  /// Requires a direction ≠ 0. May be called from several threads at once.
  [[nodiscard]] virtual SearchResult search(const Ray<Rational> &ray) const = 0;
};

/// Asks one triangle after the other, as note PG 7 does.
class PlainHitSearch final : public HitSearch {
public:
  /// Requires finite coordinates.
  explicit PlainHitSearch(const TriangleMesh &mesh);
  [[nodiscard]] SearchResult search(const Ray<Rational> &ray) const override;

private:
  std::vector<Triangle<double>> m_triangles;
  bool m_areTame; ///< all of them
};

/// The quickest way to search a mesh: a tree where it has more than a few triangles and this library is built
/// with Embree, or else one triangle after the other. Requires finite coordinates.
[[nodiscard]] std::unique_ptr<const HitSearch> makeHitSearch(const TriangleMesh &mesh);

/// The triangles of a mesh, each with its corners.
[[nodiscard]] std::vector<Triangle<double>> trianglesOf(const TriangleMesh &mesh);

} // namespace halfspace
