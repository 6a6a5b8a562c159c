#include "geometry/search/hit_finder.h"

#include "geometry/search/nearest_so_far.h"
#include "geometry/search/triangle_tree.h"

#include <cassert>
#include <utility>

namespace halfspace {

struct HitFinder::Scene {
  Scene(std::vector<Triangle<double>> given, const std::atomic<bool> *cancelled)
      : triangles(std::move(given)), tree(triangles, cancelled) {}

  std::vector<Triangle<double>> triangles;
  TriangleTree tree;
};

HitFinder::HitFinder(std::vector<Triangle<double>> triangles, const std::atomic<bool> *cancelled)
    : m_scene(std::make_unique<const Scene>(std::move(triangles), cancelled)) {}
HitFinder::~HitFinder() = default;

std::optional<NearestHit> HitFinder::find(const Ray<double> &ray) const {
  assert(!isZero(ray.direction));
  NearestSoFar nearest(ray, m_scene->triangles, m_scene->tree.isTame());
  if (!m_scene->tree.search(ray, nearest))
    nearest.offerAll();
  return nearest.result();
}

SearchResult HitFinder::search(const Ray<Rational> &ray) const {
  assert(!isZero(ray.direction));
  const std::optional<Rational> start = m_scene->tree.approach(ray);
  if (!start)
    return {};
  const Ray<Rational> near{pointAt(ray, *start), ray.direction};
  const RoundedRay rounded(near);
  NearestSoFar nearest(rounded, m_scene->triangles, m_scene->tree.isTame());
  std::optional<SearchCost> cost = m_scene->tree.search(near, nearest);
  if (!cost)
    cost = nearest.offerAll();
  SearchResult result{nearest.exactResult(), *cost};
  if (result.nearest)
    result.nearest->t += *start;
  return result;
}

} // namespace halfspace
