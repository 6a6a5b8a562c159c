// The 3D view: a figure, its handles, and the mouse and keys that move them.
#pragma once

#include "widgets/picture/camera_views.h"
#include "widgets/picture/composer.h"
#include "widgets/picture/hand/grips.h"
#include "widgets/picture/hand/handle_drag.h"
#include "widgets/scene/shape_scene.h"
#include "widgets/session_model.h"
#include "widgets/view/extent_glide.h"
#include "widgets/view/frame_pacer.h"
#include "widgets/view/mark_fade.h"
#include "widgets/view/previous_views.h"

#include <QElapsedTimer>
#include <QRect>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>
#include <QVariantAnimation>

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

/// Whatever else a window shows of the outcome is never seen beside an older picture: what is stale is drawn
/// before the window is put together.
class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

public:
  /// The typesetter must outlive it.
  SceneView(SessionModel &model, const Typesetter &typesetter, QWidget *parent = nullptr);
  ~SceneView() override;

  /// What the surfaces of a program with such a view must be like: the default format, before the first.
  [[nodiscard]] static QSurfaceFormat surfaceFormat();

  void setTheme(const Theme &theme);
  /// Marks that stand out beside the hovered one, as when their terms are hovered.
  void setHighlighted(std::set<std::string> markIds);
  [[nodiscard]] const std::set<std::string> &highlighted() const { return m_highlighted; }
  /// Hides the numbers in labels, while a question asks for them.
  void setNumbersHidden(bool hidden);
  /// Whether the camera glides from view to view and new marks of a step fade in.
  void setMotion(bool on);
  /// Makes type, lines and handles larger; 1 is their usual size.
  void setSizeScale(double scale);

  /// What lies over the view, in its own pixels: labels keep off it, and the figure is fitted into the view
  /// beside it. What comes and goes there belongs to it all the time, so that the figure does not.
  void setCovered(const std::vector<QRect> &rectangles);

  /// As the lesson begins.
  void goHome();
  /// The whole figure from another side.
  void setAxisView(AxisView view);
  void fit();
  /// Another figure: as the lesson begins, or fitted where the learner had looked around.
  void showAnother();
  /// The whole figure along its first plane or triangle, so that it is seen as a line.
  void lookAlongPlane();
  /// The whole figure from straight in front of its first plane or triangle.
  void facePlane();
  /// Looks along the first ray or line, or at the whole figure against it.
  void lookAlongCourse(AlongCourse way);
  void setOrthographic(bool on);
  /// As before the view was turned, moved or chosen last; step by step further back.
  void showPreviousView();
  [[nodiscard]] bool hasPreviousView() const { return !m_previousViews.isEmpty(); }
  [[nodiscard]] bool orthographic() const { return m_camera.orthographic; }

  [[nodiscard]] const Camera &camera() const { return m_camera; }
  [[nodiscard]] PixelSize pixelSize() const;
  /// How many of those pixels a design pixel has, in which labels, thicknesses and handles are measured.
  [[nodiscard]] double designRatio() const { return devicePixelRatioF() * m_sizeScale; }
  /// What is drawn now, without handles: for pictures.
  [[nodiscard]] SceneContent pictureContent() const;

  /// What stands beside the selected handle: how it is moved; as LaTeX.
  [[nodiscard]] std::string toolNote() const {
    const auto tool = gizmo();
    return tool ? tool->note : std::string();
  }
  /// What is drawn at this moment, while something is dragged or glides.
  [[nodiscard]] Figure drawnFigure() const { return m_extents.drawn(m_figure); }

  /// The pixel of the widget (not of the device) at which a handle is drawn, if it is in view.
  [[nodiscard]] std::optional<QPoint> handlePosition(const std::string &handleId) const;
  [[nodiscard]] const std::string &selectedHandle() const { return m_selected; }
  void selectHandle(const std::string &handleId);
  /// The coordinate of the selected handle, or the first of its object where it moves more than one.
  [[nodiscard]] std::optional<CoordinateId> selectedCoordinate() const;
  /// Whether the selected handle is a corner of an object whose corners come and go: a polygon, a prism.
  [[nodiscard]] bool isCornerSelected() const;
  /// Puts a corner behind the selected one, or takes that away; where there are as many or as few as there
  /// may be, the hint says so.
  void addCorner();
  void removeCorner();
  /// Ends what the mouse began, as its release does.
  void finishDrag();

signals:
  void orthographicChanged(bool on);
  void markHovered(const QString &markId);  ///< empty: none
  void hint(const QString &words);          ///< what can be done, or what a drag just snapped to
  void selectionChanged();                  ///< of a handle, or of what can be done with it
  void previousViewsChanged();              ///< there is a first one, or none any more
  void noticeChanged(const QString &words); ///< why not all surfaces are drawn; empty: all are
  void dismissed();                         ///< Escape, while nothing is dragged
  void frameDrawn(const halfspace::FrameTimes &times);

protected:
  void paintGL() override;
  bool event(QEvent *event) override;
  bool eventFilter(QObject *watched, QEvent *event) override;
  void showEvent(QShowEvent *event) override;
  void mousePressEvent(QMouseEvent *event) override;
  void mouseMoveEvent(QMouseEvent *event) override;
  void mouseReleaseEvent(QMouseEvent *event) override;
  void mouseDoubleClickEvent(QMouseEvent *event) override;
  void wheelEvent(QWheelEvent *event) override;
  void keyPressEvent(QKeyEvent *event) override;
  void keyReleaseEvent(QKeyEvent *event) override;
  void leaveEvent(QEvent *event) override;
  void resizeEvent(QResizeEvent *event) override;
  bool focusNextPrevChild(bool next) override;

private:
  enum class Gesture { None, Turn, Pan, Handle };

  [[nodiscard]] glm::dvec2 devicePixel(const QPointF &position) const;
  [[nodiscard]] View screen() const;
  [[nodiscard]] const Handle *findHandle(const std::string &id) const;
  [[nodiscard]] std::vector<Grip> grips() const;
  /// The handle that is grabbed within so many design pixels of what is seen of it.
  [[nodiscard]] const Handle *handleAt(glm::dvec2 pixel, double margin) const;
  [[nodiscard]] std::optional<Gizmo> gizmo() const;
  /// Of the handles that can be grabbed from where the camera stands.
  [[nodiscard]] std::vector<Knob> knobs() const;
  [[nodiscard]] std::string markOf(const Handle &handle) const;

  [[nodiscard]] SceneContent interactiveContent() const;
  void takeOutcome();
  /// While something is dragged, all others stay drawn as far as they were.
  void holdExtents();
  /// After an edit of another sort they glide there.
  void glideFrom(Extents before);
  void takeStage();
  /// The session's scene in units of the stage.
  [[nodiscard]] PlacedScene stagedScene() const {
    return toStage({m_model.session().scene, m_model.evaluation()}, m_stage);
  }
  [[nodiscard]] Figure staged(const Figure &figure) const { return toStage(figure, m_stage); }
  void prepare();
  void tellNotice(bool leavesOutSurfaces);
  /// Takes the content anew, and draws it.
  void updateContent();
  /// Draws what is there from where the camera is now.
  void showMoved();
  /// What a pointer at a pixel would take hold of.
  struct Hold {
    const Handle *handle = nullptr;
    std::optional<Gizmo::Part> part; ///< of the selected handle's tool, where that is meant
  };
  [[nodiscard]] Hold holdAt(glm::dvec2 pixel) const;
  /// What the selected handle does not move while it is dragged: "z = 4 fixed", as LaTeX.
  [[nodiscard]] std::string fixedNote(const Handle &handle) const;
  [[nodiscard]] std::optional<Gizmo::Part> gizmoPartUnder(glm::dvec2 pixel) const;
  void hover(glm::dvec2 pixel);
  /// Presses the handle or the tool's part at this pixel, if there is one.
  bool pressTool(glm::dvec2 pixel, Qt::KeyboardModifiers modifiers);
  void pressHandle(const Handle &pressed, DragMode mode, glm::dvec2 pixel);
  /// Takes hold of the picture, to turn or to move it.
  void pressPicture(Gesture gesture);
  void frame();
  void followPointer();
  void showCaught(const std::string &caught);
  void cancelDrag();
  /// Forgets what the mouse holds.
  void letGo();
  void dismiss();
  void setDragMode(DragMode mode);
  void moveCamera(const QPointF &position);
  /// The session has this view from now on.
  void keepView(const Camera &camera);
  /// The session's view, or as the lesson begins.
  void takeView();
  /// What a change of the view's size did to the camera: the next one begins where that one did, so that a
  /// view that gets its size back has its camera back.
  struct Resize {
    Camera before;
    PixelSize size; ///< before
    Camera after;
  };

  /// From where a camera stands, of all that belongs to a figure: itself, the handles, and the axes if they
  /// do.
  [[nodiscard]] Camera fittedTo(Camera from, const Figure &figure, bool axes) const;
  /// With all that is near what is given in view, and the axes.
  [[nodiscard]] Camera fittedToGiven(const Camera &from) const;
  [[nodiscard]] Camera home() const;
  /// At home the figure stays fitted to the room that there is; elsewhere what was between the left and the
  /// right side stays there.
  void keepInView();
  /// All of the figure in view, from the direction that the camera has.
  void showAll();
  [[nodiscard]] bool isInView(const Handle &handle) const;
  void noticeTyped(const std::vector<Handle> &before);
  /// As a menu asks for it.
  void chooseView(const Camera &camera);
  void glideTo(const Camera &camera);
  bool stepSelected(const QKeyEvent &event);
  /// Tells why an edit was refused; false where it was not.
  bool showRefusal(const QString &sentence);
  /// The object of the selected handle where that is one of its coordinates; null elsewhere.
  [[nodiscard]] const Object *objectOfSelected() const;
  bool lockAxis(int key);
  /// Suspends snapping, or goes on with it, at once.
  void setSuspended(bool suspended);
  void selectNext(bool forward);
  void showHint();

  SessionModel &m_model;
  Composer m_composer;
  ShapeScene m_scene;
  QString m_notice; ///< as it was told
  Theme m_theme;
  Stage m_stage; ///< the model's, that the camera is on
  Camera m_camera;
  double m_sizeScale = 1;
  bool m_motion = true;
  bool m_numbersHidden = false;
  PreviousViews m_previousViews;   ///< on the same stage
  bool m_hasTypedAway = false;     ///< something was typed out of the view
  bool m_atHome = true;            ///< nobody has moved the camera since the lesson began
  std::vector<PixelBox> m_covered; ///< parts of the view
  PixelSize m_size;                ///< that the camera is for
  std::optional<Resize> m_resize;  ///< the newest since somebody has moved the camera

  Figure m_figure; ///< what is shown, on the stage
  std::vector<Handle> m_handles;
  std::string m_selected; ///< a handle's id
  std::string m_hovered;  ///< a handle's id
  std::optional<Gizmo::Part> m_hotPart;
  std::string m_hoveredMark;
  std::set<std::string> m_highlighted;
  bool m_vertical = false; ///< whether the selected handle moves up and down when it is grabbed

  Gesture m_gesture = Gesture::None;
  Qt::MouseButton m_button = Qt::NoButton;     ///< that began the gesture
  GestureToken m_held = GestureToken::Nobodys; ///< the model's gesture
  std::optional<HandleDrag> m_drag;
  int m_dragsDone = 0;         ///< by a hand that knows by now how it goes
  Place m_pivot{};             ///< what the picture is turned about
  std::string m_caught;        ///< the special case that the drag has snapped to
  bool m_isSuspended = false;  ///< whether a key is held that suspends snapping
  bool m_clickToggles = false; ///< whether the press was on the handle that was selected already
  bool m_moved = false;        ///< whether the pointer has left the place of the press
  QPointF m_pressed;
  QPointF m_lastPointer;
  std::optional<QPointF> m_pendingPointer; ///< the newest pointer position that no frame has taken up
  bool m_contentStale = true;
  FramePacer m_frames;
  QTimer m_restTimer; ///< ends the quick drawing of what moves
  QVariantAnimation m_glide;
  MarkFade m_fade;
  ExtentGlide m_extents;
  FrameTimes m_times; ///< of the next frame, as far as they are known
  std::chrono::steady_clock::time_point m_outcomeTaken;
};

} // namespace halfspace
