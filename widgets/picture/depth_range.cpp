#include "widgets/picture/depth_range.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {
namespace {

/// Near and far clipping planes keep this distance, in parts of the depth, from what they enclose …
constexpr double clippingMargin = 0.02;
/// … and the near one is never nearer than this part of the far one: depth values are too coarse otherwise.
constexpr double leastNearPerFar = 1e-4;
/// What lies farther away than so many times the distance of the target is cut off, so that the near plane
/// never cuts off what the camera looks at.
constexpr double farthestPerDistance = 1000;

} // namespace

DepthRange depthsOf(const std::vector<Place> &places, const std::optional<AxesReach> &axes,
                    const SceneContent &content, const Camera &camera) {
  const Place eye = camera.eye();
  double nearest = camera.distance();
  double farthest = nearest;
  const double around = camera.height;
  const auto enclose = [&](Place place, double margin) {
    const double depth = glm::dot(place - eye, camera.viewDirection());
    nearest = std::min(nearest, depth - margin);
    farthest = std::max(farthest, depth + margin);
  };
  enclose(Place(camera.target.x, camera.target.y, 0), around);
  if (axes) {
    enclose(axes->low, around / 4);
    enclose(axes->high, around / 4);
    enclose(Place(0), std::max({axes->high.x, axes->high.y, axes->high.z}));
  }
  for (const Place &place : places) {
    enclose(place, around / 8);
    enclose({place.x, place.y, 0}, around / 8);
  }
  for (const Knob &knob : content.knobs)
    enclose(knob.at, around / 4);
  if (content.gizmo)
    enclose(content.gizmo->at, around / 4);
  farthest = std::min(farthest * (1 + clippingMargin), camera.distance() * farthestPerDistance);
  return {std::max(nearest * (1 - clippingMargin), farthest * leastNearPerFar), farthest};
}

} // namespace halfspace
