#include "lessons/figure/mark.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {
namespace {

/// Lets a side of a patch reach behind a covered place.
void cover(Extent &extent, double coordinate) {
  extent.low = std::clamp(coordinate - patchMargin, -maximumPatchReach, extent.low);
  extent.high = std::clamp(coordinate + patchMargin, extent.high, maximumPatchReach);
}

/// The unit directions of a patch's sides, a horizontal one first. The normal is not zero.
std::pair<Place, Place> sidesOf(const PlanePatchMark &patch) {
  const Place normal = glm::normalize(patch.normal);
  const bool isHorizontal = normal.x == 0 && normal.y == 0;
  const Place level = isHorizontal ? Place(1, 0, 0) : glm::normalize(Place(-normal.y, normal.x, 0));
  return {level, glm::cross(normal, level)};
}

bool hasSides(const PlanePatchMark &patch) {
  return patch.normal != Place(0) && isFinite(patch.normal) && isFinite(patch.center);
}

} // namespace

std::string partOf(const std::string &mark, std::size_t number) {
  return number == 0 ? mark : mark + "/" + std::to_string(number);
}

Hue hueOf(Subject subject) {
  switch (subject) {
  case Subject::Neutral:
    return Hue::Grey;
  case Subject::Plane:
    return Hue::Blue;
  case Subject::Point:
    return Hue::Orange;
  case Subject::Ray:
    return Hue::Yellow;
  case Subject::Triangle:
  case Subject::EdgeU:
    return Hue::Green;
  case Subject::EdgeV:
    return Hue::Purple;
  case Subject::Measure:
    return Hue::Pink;
  }
  return Hue::Grey;
}

Extent extentOf(const RayMark &ray) {
  if (ray.held)
    return {ray.held->low, std::max(ray.held->high, ray.meets ? glm::distance(ray.origin, *ray.meets) : 0)};
  return {0, ray.meets ? glm::distance(ray.origin, *ray.meets) + beyondHit : openRayLength};
}

Extent extentOf(const LineMark &line) {
  const Place along = glm::normalize(line.direction);
  Extent extent = line.held.value_or(Extent{-lineReach, lineReach});
  const double beyond = line.held ? 0 : beyondHit;
  for (const Place &covered : line.covers) {
    const double at = glm::dot(covered - line.through, along);
    extent.low = std::min(extent.low, at - beyond);
    extent.high = std::max(extent.high, at + beyond);
  }
  return extent;
}

std::pair<Extent, Extent> extentOf(const PlanePatchMark &patch) {
  if (patch.held)
    return *patch.held;
  const Extent least{-minimumPatchSide / 2, minimumPatchSide / 2};
  std::pair<Extent, Extent> extents{least, least};
  if (!hasSides(patch))
    return extents;
  const auto [level, slope] = sidesOf(patch);
  for (const Place &covered : patch.covers) {
    if (!isFinite(covered))
      continue;
    cover(extents.first, glm::dot(covered - patch.center, level));
    cover(extents.second, glm::dot(covered - patch.center, slope));
  }
  return extents;
}

Place endOf(const RayMark &ray) { return ray.origin + glm::normalize(ray.direction) * extentOf(ray).high; }

std::pair<Place, Place> endsOf(const LineMark &line) {
  const Place along = glm::normalize(line.direction);
  const Extent extent = extentOf(line);
  return {line.through + along * extent.low, line.through + along * extent.high};
}

Place shownVector(const ArrowMark &arrow) {
  return arrow.drawnLength ? glm::normalize(arrow.vector) * *arrow.drawnLength : arrow.vector;
}

std::vector<Place> cornersOf(const PlanePatchMark &patch) {
  if (!hasSides(patch))
    return {};
  const auto [level, slope] = sidesOf(patch);
  const auto [along, upward] = extentOf(patch);
  const auto corner = [&, side = level, rise = slope](double a, double b) {
    return patch.center + side * a + rise * b;
  };
  return {corner(along.low, upward.low), corner(along.high, upward.low), corner(along.high, upward.high),
          corner(along.low, upward.high)};
}

} // namespace halfspace
