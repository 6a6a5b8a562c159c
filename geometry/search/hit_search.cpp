#include "geometry/search/hit_search.h"

#include "geometry/search/large_pages.h"
#include "geometry/search/nearest_so_far.h"

#include <algorithm>
#include <cassert>

namespace halfspace {
namespace {

bool areTame(const std::vector<Triangle<double>> &triangles) {
  return std::all_of(triangles.begin(), triangles.end(),
                     [](const Triangle<double> &triangle) { return isTame(triangle); });
}

} // namespace

std::vector<Triangle<double>> trianglesOf(const TriangleMesh &mesh) {
  std::vector<Triangle<double>> triangles;
  reserveInLargePages(triangles, mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    triangles.push_back(mesh.triangle(i));
  return triangles;
}

PlainHitSearch::PlainHitSearch(const TriangleMesh &mesh)
    : m_triangles(trianglesOf(mesh)), m_areTame(areTame(m_triangles)) {}

SearchResult PlainHitSearch::search(const Ray<Rational> &ray) const {
  assert(!isZero(ray.direction));
  const RoundedRay rounded(ray);
  NearestSoFar nearest(rounded, m_triangles, m_areTame);
  const SearchCost cost = nearest.offerAll();
  return {nearest.exactResult(), cost};
}

} // namespace halfspace
