// The link between the scene's units and design pixels, in which thicknesses, labels and knobs are measured.
#pragma once

#include "widgets/picture/camera.h"

namespace halfspace {

/// Thicknesses are given for a view that is this many design pixels high …
inline constexpr double designHeight = 800;
/// … and shows so many scene units from bottom to top.
inline constexpr double designUnits = 21;

/// The pixels that a design pixel has in a picture where all is as large as its height says.
[[nodiscard]] inline double ownPixelRatio(PixelSize size) { return size.height / designHeight; }

/// What thicknesses in scene units are multiplied by, so that they measure the same in design pixels at the
/// target, whatever the view shows.
[[nodiscard]] inline double designScale(const Camera &camera, PixelSize size, double pixelRatio) {
  return camera.height / size.height * pixelRatio * (designHeight / designUnits);
}

} // namespace halfspace
