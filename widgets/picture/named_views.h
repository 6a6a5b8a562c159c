// The views of a scene that can be asked for by name.
#pragma once

#include "widgets/picture/camera_views.h"

namespace halfspace {

/// What a view looks at, in units of its stage.
struct Sight {
  Figure whole;                 ///< of the scene
  Figure shown;                 ///< of the step, the part that is drawn
  std::vector<Place> handles{}; ///< where they are drawn
  CameraView start{};           ///< how the lesson begins
  bool hasAxes = true;          ///< whether the scene's axes are on the stage
};

/// The places of what is drawn of a sight, with its handles.
[[nodiscard]] std::vector<Place> placesOf(const Sight &sight);

enum class NamedView {
  Home,          ///< as the lesson begins
  Fit,           ///< all that is drawn, from the direction that the camera has
  Whole,         ///< all that is near what is given, and the axes, likewise
  Front,         ///< the whole figure against x
  Right,         ///< … against y
  Top,           ///< … against z
  AlongPlane,    ///< … along its first plane or triangle, so that it is seen as a line
  FacingPlane,   ///< … from straight in front of that
  DownCourse,    ///< along the first ray or line that is drawn
  AgainstCourse, ///< the whole figure against it: the eye looks back from beyond what it leads to
};

/// The camera of a named view, for a view with the camera that it has now. It is as orthographic as that.
[[nodiscard]] Camera seenAs(NamedView name, const Sight &sight, const View &view);

} // namespace halfspace
