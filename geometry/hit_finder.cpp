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
HitFinder::HitFinder(HitFinder &&) noexcept = default;
HitFinder &HitFinder::operator=(HitFinder &&) noexcept = default;
HitFinder::~HitFinder() = default;

std::optional<NearestHit> HitFinder::find(const Ray<double> &ray) const {
  assert(!isZero(ray.direction));
  NearestSoFar nearest(ray, m_scene->triangles, m_scene->tree.isTame());
  if (!m_scene->tree.search(ray, nearest))
    for (std::size_t i = 0; i < m_scene->triangles.size(); ++i)
      nearest.offer(i);
  return nearest.result();
}

} // namespace halfspace
