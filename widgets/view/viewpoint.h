// From where a view looks at the session's scene, and how it gets there.
#pragma once

#include "widgets/picture/named_views.h"
#include "widgets/picture/resized_camera.h"
#include "widgets/session_model.h"
#include "widgets/view/camera_glide.h"
#include "widgets/view/previous_views.h"

#include <functional>

namespace halfspace {

/// What a view is like that a camera is for.
struct Screen {
  PixelSize size;
  double pixelRatio = 1; ///< pixels that a design pixel has
  bool moves = false;    ///< whether the camera glides from view to view, as there is somebody to see it
};

/// The camera of a view, in units of the model's stage. It is at home until somebody moves it: there the
/// figure stays fitted to the room that there is. The session keeps where else it is put.
class Viewpoint : public QObject {
  Q_OBJECT

public:
  /// `screen` tells at any time what the view is like; `takeScreen` is to be called when that changes.
  Viewpoint(SessionModel &model, std::function<Screen()> screen);

  [[nodiscard]] const Camera &camera() const { return m_camera; }
  /// The camera with its screen and what covers that.
  [[nodiscard]] View view() const;
  /// Of what is in view.
  [[nodiscard]] Place middle() const;

  /// Goes to a view that is asked for by its name.
  void show(NamedView name);
  /// Another figure: as the lesson begins, or the whole of it where the learner had looked around.
  void showAnother();
  void setOrthographic(bool on);
  /// As before the view was turned, moved or chosen last; step by step further back.
  void showPrevious();
  /// Those that it goes back to, in units of the stage.
  [[nodiscard]] PreviousViews &previous() { return m_previous; }

  /// A camera that is on its way stays where it is.
  void stop() { m_glide.stop(); }
  /// … is where it goes to.
  void arrive() { m_glide.arrive(); }
  /// A hand has put it there.
  void moveTo(const Camera &camera);

  /// Parts of the view that something lies over: the figure is fitted into the view beside them.
  void setCovered(std::vector<PixelBox> covered);
  /// The screen is another one. Away from home what was between the left and the right side stays there.
  void takeScreen();
  /// The model shows another lesson: as its session says, else at home. There is no view to go back to.
  void takeLesson();
  /// Looks at the same part of the scene where the model's stage is another one, with all of it in view.
  void takeStage();

  /// There is more in the figure, or less: at home all of it stays in view, and the camera where it is as
  /// long as it is.
  void takeGrown();
  /// What was typed put something to these places, with the view as it is.
  void noticeTyped(const std::vector<Place> &places);
  /// Whether one of them is out of view, and nobody has chosen another view since.
  [[nodiscard]] bool hasTypedAway() const { return m_hasTypedAway; }

signals:
  void moved();   ///< the camera is on the move, by a hand or by itself
  void changed(); ///< it is elsewhere at once, or the screen is another one
  void orthographicChanged(bool on);

private:
  [[nodiscard]] Sight sight() const;
  /// As a menu asks for it.
  void choose(const Camera &camera);
  void glideTo(const Camera &camera);
  /// The session has this view from now on.
  void keep(const Camera &camera);
  /// All of the figure in view, from the direction that the camera has.
  void showAll();
  [[nodiscard]] bool areInView(const std::vector<Place> &places) const;

  SessionModel &m_model;
  std::function<Screen()> m_screen;
  Stage m_stage; ///< the model's, that the camera is on
  Camera m_camera;
  CameraGlide m_glide;
  PreviousViews m_previous;
  ResizedCamera m_resized;
  std::vector<PixelBox> m_covered;
  bool m_isAtHome = true; ///< nobody has moved the camera since the lesson began
  bool m_hasTypedAway = false;
};

} // namespace halfspace
