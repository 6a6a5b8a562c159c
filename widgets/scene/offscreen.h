// Pictures without a window: EGL without a display server.
#pragma once

#include "lessons/result.h"
#include "widgets/picture/labels/label_setter.h"
#include "widgets/picture/rgba_image.h"
#include "widgets/picture/scene_content.h"
#include "widgets/scene/job_thread.h"

#include <memory>
#include <optional>

namespace halfspace {

struct PictureRequest {
  SceneContent content;
  /// Another picture of the same: where labels stand in it they stay, as long as nothing comes upon them.
  std::optional<SceneContent> labelledLike;
  /// Likewise for the picture that was drawn or arranged last.
  bool isLabelledLikeLast = false;
  Camera camera;
  Theme theme;
  PixelSize size{1600, 1000};
  bool transparent = false;
  /// The pixels that a design pixel has; nothing: all is scaled to the picture's height, and has its usual
  /// size at a height of 800.
  std::optional<double> pixelRatio;
};

/// A picture, as large as asked, with straight alpha, rows from top to bottom.
struct DrawnPicture : RgbaImage {
  bool leavesOutSurfaces = false; ///< as `ShapeList` has it
};

/// The widest and highest picture that is drawn.
inline constexpr int maxPictureSide = 16384;

/// Draws pictures, one after the other, in a thread of its own: a context that a live window has current in
/// the caller's would be in the way. What takes time to be opened (the context, its programs) serves for all
/// of them, and what two that follow one another have in common is made once. No picture depends on those
/// before it.
class OffscreenPainter {
public:
  /// Both work in the painter's thread, while the caller waits.
  OffscreenPainter(LabelSetter set, LabelPainter labels);
  ~OffscreenPainter();
  OffscreenPainter(const OffscreenPainter &) = delete;
  OffscreenPainter &operator=(const OffscreenPainter &) = delete;

  /// Fails with a sentence where no OpenGL 3.2 is to be had, and where there is not enough memory: then the
  /// next begins anew.
  [[nodiscard]] Result<DrawnPicture> draw(const PictureRequest &request);
  /// Gives labels their places as `draw` would, for a picture that is labelled like this one. Where nothing
  /// can be drawn, nothing is done.
  void arrange(const PictureRequest &request);

private:
  class Studio;
  /// In the thread. Why there is none.
  [[nodiscard]] std::optional<Problem> openStudio();

  LabelSetter m_set;
  LabelPainter m_labels;
  std::unique_ptr<Studio> m_studio; ///< made and ended in the thread
  JobThread m_thread;
};

} // namespace halfspace
