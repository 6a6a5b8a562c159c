// What is drawn for the hand: gizmo, knobs and the drop line. All of constant size on the screen.
#pragma once

#include "widgets/scene/figure_scene.h"
#include "widgets/scene/mesh.h"

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

[[nodiscard]] Mesh toolsMesh(const SceneContent &content, const Theme &theme, const View &view);

} // namespace halfspace
