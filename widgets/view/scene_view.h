// The 3D view: a figure, its handles, and the mouse and keys that move them.
#pragma once

#include "widgets/view/object_hand.h"
#include "widgets/view/scene_drawing.h"

namespace halfspace {

/// A widget that is put together from parts with one task each: where it looks from (Viewpoint), what it
/// draws of the session (DrawnFigure), the handles with their tools (SceneHandles), what keys and menus do
/// with them (HandleEdits), the one in the hand (HandleHold), the events (SceneInput), the tool that makes
/// objects (ObjectHand) and the frames (SceneDrawing). Here they are told of each other; whoever wants
/// something of one of them asks it.
class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

public:
  /// The typesetter must outlive it.
  SceneView(SessionModel &model, const Typesetter &typesetter, QWidget *parent = nullptr);

  /// What the surfaces of a program with such a view must be like: the default format, before the first.
  [[nodiscard]] static QSurfaceFormat surfaceFormat();

  void setTheme(const Theme &theme);
  /// Whether the camera glides from view to view and new marks of a step fade in.
  void setMotion(bool on);
  /// Makes type, lines and handles larger; 1 is their usual size.
  void setSizeScale(double scale);
  /// What lies over the view, in its own pixels: labels keep off it, and the figure is fitted into the view
  /// beside it. What comes and goes there belongs to it all the time, so that the figure does not.
  void setCovered(const std::vector<QRect> &rectangles);

  [[nodiscard]] const ViewScreen &screen() const { return m_screen; }
  [[nodiscard]] Viewpoint &viewpoint() { return m_viewpoint; }
  [[nodiscard]] DrawnFigure &drawn() { return m_drawn; }
  [[nodiscard]] SceneHandles &handles() { return m_handles; }
  [[nodiscard]] HandleEdits &edits() { return m_edits; }
  [[nodiscard]] SceneInput &input() { return m_input; }
  [[nodiscard]] ObjectHand &objectHand() { return m_objectHand; }
  [[nodiscard]] SceneDrawing &drawing() { return m_drawing; }

signals:
  void hint(const QString &words); ///< what can be done, or what a drag just snapped to

protected:
  void paintGL() override;
  void resizeEvent(QResizeEvent *event) override;
  bool focusNextPrevChild(bool next) override;

private:
  void followModel();
  void joinParts();
  void takeLesson();
  void takeOutcome();
  void tellHint() { emit hint(m_objectHand.tool() ? m_objectHand.prompt() : m_handles.hint()); }

  SessionModel &m_model;
  ViewScreen m_screen;
  Viewpoint m_viewpoint;
  DrawnFigure m_drawn;
  HandleHold m_hold;
  SceneHandles m_handles;
  HandleEdits m_edits;
  SceneInput m_input;
  ObjectHand m_objectHand;
  SceneDrawing m_drawing;
};

} // namespace halfspace
