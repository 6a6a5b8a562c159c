#include "geometry/hit_search.h"

#include "geometry/decide.h"
#include "geometry/nearest_so_far.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace halfspace {
namespace {

bool areTame(const std::vector<Triangle<double>> &triangles) {
  return std::all_of(triangles.begin(), triangles.end(),
                     [](const Triangle<double> &triangle) { return isTame(triangle); });
}

} // namespace

std::optional<Ray<double>> inDoubles(const Ray<Rational> &ray) {
  const Ray<double> rounded{toDouble(ray.origin), toDouble(ray.direction)};
  if (!std::isfinite(largestCoordinate(rounded.origin)) ||
      !std::isfinite(largestCoordinate(rounded.direction)))
    return {};
  const Ray<Rational> again = exactly(rounded);
  if (again.origin != ray.origin || again.direction != ray.direction)
    return {};
  return rounded;
}

std::vector<Triangle<double>> trianglesOf(const TriangleMesh &mesh) {
  std::vector<Triangle<double>> triangles;
  triangles.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    triangles.push_back(mesh.triangle(i));
  return triangles;
}

PlainHitSearch::PlainHitSearch(const TriangleMesh &mesh)
    : m_triangles(trianglesOf(mesh)), m_areTame(areTame(m_triangles)) {}

SearchResult PlainHitSearch::search(const Ray<Rational> &ray) const {
  assert(!isZero(ray.direction));
  const auto exact = inDoubles(ray);
  const Ray<double> rounded = exact.value_or(Ray<double>{toDouble(ray.origin), toDouble(ray.direction)});
  NearestSoFar nearest =
      exact ? NearestSoFar(rounded, m_triangles, m_areTame) : NearestSoFar(rounded, ray, m_triangles);
  for (std::size_t i = 0; i < m_triangles.size(); ++i)
    nearest.offer(i);
  return {nearest.exactResult(), {0, m_triangles.size()}};
}

} // namespace halfspace
