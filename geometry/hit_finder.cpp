#include "geometry/hit_finder.h"

#include "geometry/nearest_so_far.h"
#include "geometry/triangle_tree.h"

#include <cassert>
#include <vector>

namespace halfspace {

struct HitFinder::Scene {
  explicit Scene(std::span<const Triangle<double>> given)
      : triangles(given.begin(), given.end()), tree(triangles) {}

  std::vector<Triangle<double>> triangles;
  TriangleTree tree;
};

HitFinder::HitFinder(std::span<const Triangle<double>> triangles)
    : m_scene(std::make_unique<const Scene>(triangles)) {}
HitFinder::~HitFinder() = default;

SearchCost HitFinder::offerCandidates(const Ray<double> &ray, NearestSoFar &nearest) const {
  if (const auto cost = m_scene->tree.search(ray, nearest))
    return *cost;
  const std::size_t count = m_scene->triangles.size();
  for (std::size_t i = 0; i < count; ++i)
    nearest.offer(i);
  return {0, count};
}

std::optional<NearestHit> HitFinder::find(const Ray<double> &ray) const {
  assert(!isZero(ray.direction));
  NearestSoFar nearest(ray, m_scene->triangles, m_scene->tree.isTame());
  offerCandidates(ray, nearest);
  return nearest.result();
}

SearchResult HitFinder::search(const Ray<Rational> &ray) const {
  assert(!isZero(ray.direction));
  const auto exact = inDoubles(ray);
  // What rounding moves a ray by is far below what the tree's boxes are larger than they must be.
  const Ray<double> rounded = exact.value_or(Ray<double>{toDouble(ray.origin), toDouble(ray.direction)});
  NearestSoFar nearest = exact ? NearestSoFar(rounded, m_scene->triangles, m_scene->tree.isTame())
                               : NearestSoFar(rounded, ray, m_scene->triangles);
  const SearchCost cost = offerCandidates(rounded, nearest);
  return {nearest.exactResult(), cost};
}

} // namespace halfspace
