#include "widgets/picture/shapes/ball_sizes.h"

#include "widgets/picture/shapes/mark_mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <string_view>
#include <unordered_map>

namespace halfspace {
namespace {

/// The radius of a ball is at most this part of the way across the surface that it stands on …
constexpr double mostOfSurface = 0.08;
/// … but never less than this at scale 1: it is still seen on the lines that meet in it.
constexpr double leastRadius = 0.14;

/// A point of a surface lies in its box but for rounding, a part of the box.
constexpr double rounding = 1e-9;

/// What the parts of one surface have in common: `shot.saucer` of `shot.saucer/3`.
std::string_view surfaceOf(const MarkBase &mark) {
  return std::string_view(mark.id).substr(0, mark.id.find('/'));
}

} // namespace

BallSizes::BallSizes(const Figure &figure) {
  std::unordered_map<std::string_view, Surface> byName;
  for (const Mark &mark : figure.marks)
    if (const auto *part = std::get_if<PolygonMark>(&mark); part && !part->corners.empty()) {
      const Place &first = part->corners.front();
      Surface &surface = byName.try_emplace(surfaceOf(*part), Surface{first, first}).first->second;
      for (const Place &corner : part->corners)
        surface = {glm::min(surface.low, corner), glm::max(surface.high, corner)};
    }
  for (const auto &[name, surface] : byName)
    m_surfaces.push_back(surface);
}

double BallSizes::radiusOf(const PointMark &point, double thickness) const {
  const double wanted = ballRadius(point) * thickness;
  double most = wanted;
  for (const Surface &surface : m_surfaces) {
    const double across = glm::distance(surface.low, surface.high);
    const Place margin(across * rounding);
    if (glm::all(glm::lessThanEqual(surface.low - margin, point.at)) &&
        glm::all(glm::lessThanEqual(point.at, surface.high + margin)))
      most = std::min(most, mostOfSurface * across);
  }
  return std::clamp(most, std::min(leastRadius * thickness, wanted), wanted);
}

} // namespace halfspace
