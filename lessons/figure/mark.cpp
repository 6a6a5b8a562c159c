#include "lessons/figure/mark.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {
namespace {

/// How far a patch goes from its centre, both ways along one of its sides' directions.
struct Extent {
  double low = -minimumPatchSide / 2;
  double high = minimumPatchSide / 2;

  void cover(double coordinate) {
    low = std::clamp(coordinate - patchMargin, -maximumPatchReach, low);
    high = std::clamp(coordinate + patchMargin, high, maximumPatchReach);
  }
};

} // namespace

Place endOf(const RayMark &ray) {
  const double length = ray.meets ? glm::distance(ray.origin, *ray.meets) + beyondHit : openRayLength;
  return ray.origin + glm::normalize(ray.direction) * length;
}

std::pair<Place, Place> endsOf(const LineMark &line) {
  const Place along = glm::normalize(line.direction);
  double low = -lineReach;
  double high = lineReach;
  for (const Place &covered : line.covers) {
    const double at = glm::dot(covered - line.through, along);
    low = std::min(low, at - beyondHit);
    high = std::max(high, at + beyondHit);
  }
  return {line.through + along * low, line.through + along * high};
}

Place shownVector(const ArrowMark &arrow) {
  return arrow.drawnLength ? glm::normalize(arrow.vector) * *arrow.drawnLength : arrow.vector;
}

std::vector<Place> cornersOf(const PlanePatchMark &patch) {
  if (patch.normal == Place(0) || !isFinite(patch.normal) || !isFinite(patch.center))
    return {};
  const Place normal = glm::normalize(patch.normal);
  const bool isHorizontal = normal.x == 0 && normal.y == 0;
  const Place level = isHorizontal ? Place(1, 0, 0) : glm::normalize(Place(-normal.y, normal.x, 0));
  const Place slope = glm::cross(normal, level);

  Extent along;
  Extent upward;
  for (const Place &covered : patch.covers) {
    if (!isFinite(covered))
      continue;
    along.cover(glm::dot(covered - patch.center, level));
    upward.cover(glm::dot(covered - patch.center, slope));
  }
  const auto corner = [&](double a, double b) { return patch.center + level * a + slope * b; };
  return {corner(along.low, upward.low), corner(along.high, upward.low), corner(along.high, upward.high),
          corner(along.low, upward.high)};
}

} // namespace halfspace
