// Where a scene is looked at from.
#pragma once

#include <glm/vec3.hpp>

namespace halfspace {

/// It looks from the direction `from` at the point `at`, and `height` scene units fill the view from bottom to
/// top there.
struct CameraView {
  glm::dvec3 from{1.25, -0.10, 0.60};
  glm::dvec3 at{6.0, 8.0, 4.0};
  double height = 21;
  bool operator==(const CameraView &) const = default;
};

/// Where somebody has put the camera, in units of the stage that the scene is shown on.
struct ChosenView {
  CameraView view;
  bool orthographic = false;
  bool operator==(const ChosenView &) const = default;
};

} // namespace halfspace
