// What is looked at from where, on how many pixels.
#pragma once

#include "widgets/picture/camera.h"

namespace halfspace {

/// A camera and its screen.
struct View {
  Camera camera;
  PixelSize size;
  double pixelRatio = 1;
  bool operator==(const View &) const = default;

  /// The units of the stage that a design pixel spans at a place; 0 behind the eye.
  [[nodiscard]] double unitsPerDesignPixel(Place at) const {
    return camera.unitsPerPixel(at, size) * pixelRatio;
  }
};

} // namespace halfspace
