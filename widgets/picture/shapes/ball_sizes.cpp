#include "widgets/picture/shapes/ball_sizes.h"

#include "widgets/picture/shapes/mark_shapes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace halfspace {
namespace {

/// The radius of a ball is at most this part of the way across the surface that it stands on …
constexpr double mostOfSurface = 0.08;
/// … but never less than this at scale 1: it is still seen on the lines that meet in it.
constexpr double leastRadius = 0.14;

/// What the parts of one surface have in common: `shot.saucer` of `shot.saucer/3`.
std::string_view surfaceOf(const MarkBase &mark) {
  return std::string_view(mark.id).substr(0, mark.id.find('/'));
}

double distanceToSide(const Place &point, const Place &from, const Place &to) {
  const Place side = to - from;
  const double square = glm::dot(side, side);
  const double part = square > 0 ? std::clamp(glm::dot(point - from, side) / square, 0.0, 1.0) : 0;
  return glm::distance(point, from + side * part);
}

/// From a point to the nearest of a flat convex polygon.
double distanceToFace(const std::vector<Place> &corners, const Place &point) {
  Place normal(0);
  for (std::size_t i = 2; i < corners.size(); ++i)
    normal += glm::cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  double toSides = std::numeric_limits<double>::infinity();
  bool isOver = normal != Place(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Place &from = corners[i];
    const Place &to = corners[(i + 1) % corners.size()];
    toSides = std::min(toSides, distanceToSide(point, from, to));
    isOver = isOver && glm::dot(glm::cross(to - from, point - from), normal) >= 0;
  }
  return isOver ? std::abs(glm::dot(point - corners[0], glm::normalize(normal))) : toSides;
}

} // namespace

BallSizes::BallSizes(const Figure &figure) {
  std::unordered_map<std::string_view, Surface> byName;
  for (const Mark &mark : figure.marks)
    if (const auto *part = std::get_if<PolygonMark>(&mark); part && !part->corners.empty()) {
      const Place &first = part->corners.front();
      const auto [found, isNew] = byName.try_emplace(surfaceOf(*part), Surface{part->corners, first, first});
      Surface &surface = found->second;
      if (!isNew)
        surface.face.clear();
      for (const Place &corner : part->corners) {
        surface.low = glm::min(surface.low, corner);
        surface.high = glm::max(surface.high, corner);
      }
    }
  for (auto &[name, surface] : byName)
    m_surfaces.push_back(std::move(surface));
}

/// From a body it is the distance from its box: what stands within stands on it.
double BallSizes::distanceTo(const Surface &surface, const Place &point) {
  if (!surface.face.empty())
    return distanceToFace(surface.face, point);
  return glm::distance(point, glm::clamp(point, surface.low, surface.high));
}

double BallSizes::radiusOf(const PointMark &point, double thickness) const {
  const double wanted = ballRadius(point) * thickness;
  double most = wanted;
  for (const Surface &surface : m_surfaces)
    if (const double onIt = mostOfSurface * glm::distance(surface.low, surface.high); onIt < most)
      most = std::min(most, onIt + distanceTo(surface, point.at));
  return std::clamp(most, std::min(leastRadius * thickness, wanted), wanted);
}

} // namespace halfspace
