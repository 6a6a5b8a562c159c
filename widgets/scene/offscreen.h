// Pictures without a window: EGL without a display server.
#pragma once

#include "lessons/result.h"
#include "widgets/scene/figure_scene.h"

#include <optional>

namespace halfspace {

struct PictureRequest {
  SceneContent content;
  /// Another picture of the same: where labels stand in it they stay, as long as nothing comes upon them.
  std::optional<SceneContent> labelledLike;
  Camera camera;
  Theme theme;
  PixelSize size{1600, 1000};
  bool transparent = false;
  /// The pixels that a design pixel has; nothing: all is scaled to the picture's height, and has its usual
  /// size at a height of 800.
  std::optional<double> pixelRatio;
};

/// The widest and highest picture that is drawn.
inline constexpr int maxPictureSide = 16384;

/// Draws a picture as large as asked with straight alpha, rows from top to bottom. Fails with a sentence
/// where no OpenGL 3.2 is to be had.
[[nodiscard]] Result<LabelPicture> drawOffscreen(const PictureRequest &request, const LabelPainter &labels);

} // namespace halfspace
