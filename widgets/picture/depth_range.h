// How near and how far there is something to be seen.
#pragma once

#include "widgets/picture/scene_content.h"
#include "widgets/picture/shapes/ground.h"

namespace halfspace {

/// Two distances from the eye along the view, as near and far clipping planes.
struct DepthRange {
  double nearest = 1;
  double farthest = 2;
  bool operator==(const DepthRange &) const = default;
};

/// From the nearest to the farthest of what a camera shows: these places and what they cast on the ground,
/// the axes where there are any, and what the hand holds, with room for thicknesses, the grid and labels.
[[nodiscard]] DepthRange depthsOf(const std::vector<Place> &places, const std::optional<AxesReach> &axes,
                                  const SceneContent &content, const Camera &camera);

} // namespace halfspace
