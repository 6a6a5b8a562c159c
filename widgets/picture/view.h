// What is looked at from where, on how many pixels.
#pragma once

#include "widgets/picture/camera.h"

#include <vector>

namespace halfspace {

/// A camera and its screen.
struct View {
  Camera camera;
  PixelSize size;
  double pixelRatio = 1;
  std::vector<PixelBox> covered{}; ///< parts of it that something else lies over
  bool operator==(const View &) const = default;

  [[nodiscard]] PixelBox box() const { return {{0, 0}, {size.width, size.height}}; }

  /// The units of the stage that a design pixel spans at a place; 0 behind the eye.
  [[nodiscard]] double unitsPerDesignPixel(Place at) const {
    return camera.unitsPerPixel(at, size) * pixelRatio;
  }
};

} // namespace halfspace
