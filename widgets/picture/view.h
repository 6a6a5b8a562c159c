// What is looked at from where, on how many pixels.
#pragma once

#include "widgets/picture/camera.h"

namespace halfspace {

/// The view that sizes on the screen refer to.
struct View {
  Camera camera;
  PixelSize size;
  double pixelRatio = 1;
  bool operator==(const View &) const = default;

  /// The scene units that a design pixel spans at a place; 0 behind the eye.
  [[nodiscard]] double unitsPerDesignPixel(Place at) const {
    return camera.unitsPerPixel(at, size) * pixelRatio;
  }
};

} // namespace halfspace
