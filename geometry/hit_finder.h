// The first of very many triangles that a ray hits.
#pragma once

#include "geometry/ray.h"
#include "geometry/triangle.h"

#include <memory>
#include <optional>
#include <span>

namespace halfspace {

/// The most that the t of a hit is off, as a share of it, unless it is the nearest double.
inline constexpr double hitPrecision = 0x1p-36;

/// The triangle with the smallest t ≥ 0, of several the one with the lowest index.
struct NearestHit {
  std::size_t index = 0;
  double t = 0; ///< +infinity beyond the range of doubles
};

/// Many triangles, made ready once and then asked often.
///
/// The answer is that of `hitAll` over fractions, for the doubles taken as exactly the numbers that they are:
/// (1) There is one exactly where `hitAll` has hits, and its index is that of the first of them.
/// (2) So no ray slips through an edge or a corner that two triangles share.
/// (3) So ties go to the lowest index, and degenerate triangles and those whose plane the ray lies in are
///     passed over.
/// (4) Its t is within `hitPrecision` of the exact one, or the double nearest to that.
///
/// A tree of boxes proposes candidates (`TriangleTree`); each is decided by a filter with a bound on its
/// error, or else over fractions.
class HitFinder {
public:
  /// Copies the triangles. Requires finite coordinates.
  explicit HitFinder(std::span<const Triangle<double>> triangles);
  HitFinder(HitFinder &&) noexcept;
  HitFinder &operator=(HitFinder &&) noexcept;
  ~HitFinder();

  /// Requires a direction ≠ 0 and finite numbers. May be called from several threads at once.
  [[nodiscard]] std::optional<NearestHit> find(const Ray<double> &ray) const;

private:
  struct Scene;
  std::unique_ptr<const Scene> m_scene;
};

} // namespace halfspace
