// Pictures without a window: EGL without a display server.
#pragma once

#include "lessons/problem.h"
#include "widgets/scene/figure_scene.h"

#include <filesystem>

namespace halfspace {

struct PictureRequest {
  SceneContent content;
  Camera camera;
  Theme theme;
  PixelSize size{1600, 1000};
  bool transparent = false;
};

/// The widest and highest picture that is drawn.
inline constexpr int maxPictureSide = 16384;

/// Draws a picture as large as asked, everything in it scaled to its height, with straight alpha, rows from
/// top to bottom. Fails with a sentence where no OpenGL 3.2 is to be had. `pixelRatio` is 1 at a height of
/// 800.
[[nodiscard]] Result<LabelPicture> drawOffscreen(const PictureRequest &request, const LabelPainter &labels);

/// Writes a PNG file atomically: the whole picture or nothing.
[[nodiscard]] std::optional<Problem> writePng(const LabelPicture &picture, const std::filesystem::path &file);

} // namespace halfspace
