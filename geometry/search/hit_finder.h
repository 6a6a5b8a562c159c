// The first of very many triangles that a ray hits.
#pragma once

#include "geometry/search/hit_search.h"

#include <atomic>
#include <memory>
#include <optional>
#include <vector>

namespace halfspace {

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
class HitFinder final : public HitSearch {
public:
  /// Requires finite coordinates. Once `cancelled`, from another thread, making it ends soon: each triangle
  /// is asked then.
  explicit HitFinder(std::vector<Triangle<double>> triangles, const std::atomic<bool> *cancelled = nullptr);
  ~HitFinder() override;

  /// Requires a direction ≠ 0 and finite numbers. May be called from several threads at once.
  [[nodiscard]] std::optional<NearestHit> find(const Ray<double> &ray) const;
  /// A ray that is in no doubles costs a calculation with fractions for each candidate, or, 2^26 times the
  /// half width of all triangles away from them or from zero, for each triangle.
  [[nodiscard]] SearchResult search(const Ray<Rational> &ray) const override;

private:
  struct Scene;
  std::unique_ptr<const Scene> m_scene;
};

} // namespace halfspace
