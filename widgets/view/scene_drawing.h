// Draws what a view shows of a session.
#pragma once

#include "widgets/picture/composer.h"
#include "widgets/scene/shape_scene.h"
#include "widgets/view/frame_pacer.h"
#include "widgets/view/scene_handles.h"

#include <QVTKOpenGLNativeWidget.h>

#include <chrono>

namespace halfspace {

class Typesetter;

/// How long the parts of one frame took on the user-interface thread.
struct FrameTimes {
  std::chrono::nanoseconds evaluate{}; ///< pointer to new outcome; zero where the scene did not change
  std::chrono::nanoseconds panels{}; ///< outcome to all others that show it: lines, numbers, words; likewise
  std::chrono::nanoseconds update{}; ///< outcome to meshes and labels
  std::chrono::nanoseconds render{}; ///< VTK
};

/// Puts a figure and its handles into a widget, one frame for whatever has changed since the last one. What
/// is held follows the pointer once for each of them.
class SceneDrawing : public QObject {
  Q_OBJECT

public:
  SceneDrawing(QVTKOpenGLNativeWidget &widget, const Typesetter &typesetter, const Viewpoint &viewpoint,
               const DrawnFigure &drawn, const SceneHandles &handles, HandleHold &hold);
  ~SceneDrawing() override;
  SceneDrawing(const SceneDrawing &) = delete;
  SceneDrawing &operator=(const SceneDrawing &) = delete;

  void setTheme(const Theme &theme);
  /// From where the camera is now, and as the screen is.
  void request() { m_frames.request(); }
  /// What is drawn is another.
  void requestNew() { m_frames.requestNew(); }
  /// The camera moves, or what is held.
  void requestMoving() { m_frames.requestMoving(); }
  /// What is drawn glides or fades.
  void requestNewMoving() {
    m_frames.requestNew();
    m_frames.requestMoving();
  }
  /// All that belongs to the view has taken up a new outcome.
  void takeOutcome(bool inGesture);

  /// To be called before and after the view is painted: VTK draws by itself after a change of size.
  void prepare();
  void painted() { m_frames.painted(); }

  /// The id of the mark whose label or whose drawn shape lies under a pixel, or empty.
  [[nodiscard]] std::string markAt(glm::dvec2 pixel) const { return m_composer.markAt(pixel); }

signals:
  void noticeChanged(const QString &words); ///< why not all surfaces are drawn; empty: all are
  void frameDrawn(const halfspace::FrameTimes &times);

private:
  using Clock = std::chrono::steady_clock;

  void frame();
  void tellNotice(bool leavesOutSurfaces);

  QVTKOpenGLNativeWidget &m_widget;
  const Viewpoint &m_viewpoint;
  const DrawnFigure &m_drawn;
  const SceneHandles &m_handles;
  HandleHold &m_hold;
  Composer m_composer;
  ShapeScene m_scene;
  FramePacer m_frames;
  QString m_notice;   ///< as it was told
  FrameTimes m_times; ///< of the next frame, as far as they are known
  Clock::time_point m_moveBegun;
  Clock::time_point m_outcomeTaken;
};

} // namespace halfspace
