// The nearest of several triangles that a ray hits, one after the other.
#pragma once

#include "geometry/decide.h"
#include "geometry/filter.h"
#include "geometry/search/hit_search.h"
#include "geometry/search/rounded_ray.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace halfspace {

/// The nearest of the hits that were offered so far; t is compared over fractions where doubles leave it
/// open.
class NearestSoFar {
public:
  /// `tame` tells whether all triangles are.
  NearestSoFar(const Ray<double> &ray, std::span<const Triangle<double>> triangles, bool tame)
      : m_ray(ray), m_tame(tame && isTame(ray)), m_triangles(triangles) {}
  /// The same; each triangle is decided over fractions where the ray is in no doubles.
  NearestSoFar(const RoundedRay &ray, std::span<const Triangle<double>> triangles, bool tame)
      : m_ray(ray.rounded), m_exactRay(ray.isExact ? nullptr : &ray.exact),
        m_tame(ray.isExact && tame && isTame(ray.rounded)), m_triangles(triangles) {}

  /// Tells the machine that this triangle will perhaps be offered soon.
  void expect(std::size_t index) const {
    __builtin_prefetch(&m_triangles[index]);
    __builtin_prefetch(reinterpret_cast<const char *>(&m_triangles[index]) + sizeof(Triangle<double>) - 1);
  }

  /// Looks whether the ray hits a triangle, and takes it if it is nearer, or as near and of lower index.
  void offer(std::size_t index) {
    const Triangle<double> &triangle = m_triangles[index];
    if (m_tame) {
      const FilteredTriangle filtered = filterRayTriangle(m_ray, triangle);
      if (const auto which = surelyCaseOf(filtered)) {
        if (*which == RayTriangleCase::Hit)
          take(index, filtered.bounded.volume / filtered.bounded.sum);
        return;
      }
    }
    if (const auto exact = m_exactRay ? exactHit(*m_exactRay, triangle) : exactHit(m_ray, triangle)) {
      const double t = toDouble(*exact);
      take(index, {t, t * filterError}, exact);
    }
  }

  SearchCost offerAll() {
    for (std::size_t i = 0; i < m_triangles.size(); ++i)
      offer(i);
    return {0, m_triangles.size()};
  }

  /// No hit beyond this t can become the nearest.
  [[nodiscard]] double reach() const { return m_t.value + m_t.error; }
  [[nodiscard]] std::optional<NearestHit> result() const {
    if (!m_index)
      return {};
    const bool precise = std::isfinite(m_t.value) && m_t.error <= hitPrecision * m_t.value;
    return NearestHit{*m_index, precise ? m_t.value : toDouble(exactTOf(*m_index))};
  }
  [[nodiscard]] std::optional<ExactNearestHit> exactResult() const {
    if (!m_index)
      return {};
    return ExactNearestHit{*m_index, m_exactT ? *m_exactT : exactTOf(*m_index)};
  }

private:
  /// With its exact t where that is known.
  void take(std::size_t index, const Bounded &t, std::optional<Rational> exact = {}) {
    if (m_index && !isBefore(index, t, exact))
      return;
    m_index = index;
    m_t = t;
    m_exactT = std::move(exact);
  }

  [[nodiscard]] bool isBefore(std::size_t index, const Bounded &t, std::optional<Rational> &exact) {
    if (t.value + t.error < m_t.value - m_t.error)
      return true;
    if (t.value - t.error > m_t.value + m_t.error)
      return false;
    if (!exact)
      exact = exactTOf(index);
    if (!m_exactT)
      m_exactT = exactTOf(*m_index);
    return *exact < *m_exactT || (*exact == *m_exactT && index < *m_index);
  }

  [[nodiscard]] Rational exactTOf(std::size_t index) const {
    const Triangle<double> &triangle = m_triangles[index];
    return m_exactRay ? exactHit(*m_exactRay, triangle).value() : exactT(m_ray, triangle);
  }

  const Ray<double> &m_ray;
  const Ray<Rational> *m_exactRay = nullptr;
  bool m_tame;
  std::span<const Triangle<double>> m_triangles;
  std::optional<std::size_t> m_index;
  Bounded m_t{std::numeric_limits<double>::infinity(), 0};
  std::optional<Rational> m_exactT; ///< of the nearest, once it is known
};

} // namespace halfspace
