#include "geometry/hit_finder.h"

#include "geometry/nearest_so_far.h"
#include "geometry/triangle_tree.h"

#include <cassert>
#include <utility>

namespace halfspace {

struct HitFinder::Scene {
  explicit Scene(std::vector<Triangle<double>> given) : triangles(std::move(given)), tree(triangles) {}

  std::vector<Triangle<double>> triangles;
  TriangleTree tree;
};

HitFinder::HitFinder(std::vector<Triangle<double>> triangles)
    : m_scene(std::make_unique<const Scene>(std::move(triangles))) {}
HitFinder::~HitFinder() = default;

SearchCost HitFinder::offerAll(NearestSoFar &nearest) const {
  const std::size_t count = m_scene->triangles.size();
  for (std::size_t i = 0; i < count; ++i)
    nearest.offer(i);
  return {0, count};
}

std::optional<NearestHit> HitFinder::find(const Ray<double> &ray) const {
  assert(!isZero(ray.direction));
  NearestSoFar nearest(ray, m_scene->triangles, m_scene->tree.isTame());
  if (!m_scene->tree.search(ray, nearest))
    offerAll(nearest);
  return nearest.result();
}

SearchResult HitFinder::search(const Ray<Rational> &ray) const {
  assert(!isZero(ray.direction));
  const auto exact = inDoubles(ray);
  const Ray<double> rounded = exact.value_or(Ray<double>{toDouble(ray.origin), toDouble(ray.direction)});
  NearestSoFar nearest = exact ? NearestSoFar(rounded, m_scene->triangles, m_scene->tree.isTame())
                               : NearestSoFar(rounded, ray, m_scene->triangles);
  std::optional<SearchCost> cost;
  if (exact || m_scene->tree.mayBeRounded(rounded))
    cost = m_scene->tree.search(rounded, nearest);
  if (!cost)
    cost = offerAll(nearest);
  return {nearest.exactResult(), *cost};
}

} // namespace halfspace
