// The 3D view: a figure, its handles, and the mouse and keys that move them.
#pragma once

#include "widgets/view/scene_drawing.h"
#include "widgets/view/scene_input.h"

namespace halfspace {

/// A widget that is put together from parts with one task each: where it looks from (Viewpoint), what it
/// draws of the session (DrawnFigure), the handles with their tools (SceneHandles), what keys and menus do
/// with them (HandleEdits), the one in the hand (HandleHold), the events (SceneInput) and the frames
/// (SceneDrawing). Here they are told what has happened, and asked.
class SceneView : public QVTKOpenGLNativeWidget {
  Q_OBJECT

public:
  /// The typesetter must outlive it.
  SceneView(SessionModel &model, const Typesetter &typesetter, QWidget *parent = nullptr);

  /// What the surfaces of a program with such a view must be like: the default format, before the first.
  [[nodiscard]] static QSurfaceFormat surfaceFormat();

  void setTheme(const Theme &theme);
  /// Marks that stand out beside the hovered one, as when their terms are hovered.
  void setHighlighted(std::set<std::string> markIds);
  [[nodiscard]] const std::set<std::string> &highlighted() const { return m_drawn.highlighted(); }
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
  void goHome() { m_viewpoint.show(NamedView::Home); }
  /// The whole figure from another side.
  void setAxisView(AxisView view);
  void fit() { m_viewpoint.show(NamedView::Fit); }
  /// Another figure: as the lesson begins, or fitted where the learner had looked around.
  void showAnother() { m_viewpoint.showAnother(); }
  /// The whole figure along its first plane or triangle, so that it is seen as a line.
  void lookAlongPlane() { m_viewpoint.show(NamedView::AlongPlane); }
  /// The whole figure from straight in front of its first plane or triangle.
  void facePlane() { m_viewpoint.show(NamedView::FacingPlane); }
  /// Looks along the first ray or line, or at the whole figure against it.
  void lookAlongCourse(AlongCourse way);
  void setOrthographic(bool on) { m_viewpoint.setOrthographic(on); }
  /// As before the view was turned, moved or chosen last; step by step further back.
  void showPreviousView() { m_viewpoint.showPrevious(); }
  [[nodiscard]] bool hasPreviousView() const { return m_viewpoint.hasPrevious(); }

  [[nodiscard]] const Camera &camera() const { return m_viewpoint.camera(); }
  [[nodiscard]] PixelSize pixelSize() const;
  /// How many of those pixels a design pixel has, in which labels, thicknesses and handles are measured.
  [[nodiscard]] double designRatio() const { return devicePixelRatioF() * m_sizeScale; }
  /// What is drawn now, without handles: for pictures.
  [[nodiscard]] SceneContent pictureContent() const { return m_drawn.pictureContent(); }
  /// What is drawn at this moment, while something is dragged or glides.
  [[nodiscard]] Figure drawnFigure() const { return m_drawn.drawnFigure(); }

  /// What stands beside the selected handle: how it is moved; as LaTeX.
  [[nodiscard]] std::string toolNote() const;
  /// The pixel of the widget (not of the device) at which a handle is drawn, if it is in view.
  [[nodiscard]] std::optional<QPoint> handlePosition(const std::string &handleId) const;
  [[nodiscard]] const std::string &selectedHandle() const { return m_handles.selection().selectedId(); }
  void selectHandle(const std::string &handleId) { m_handles.select(handleId); }
  /// The coordinate of the selected handle, or the first of its object where it moves more than one.
  [[nodiscard]] std::optional<CoordinateId> selectedCoordinate() const {
    return m_handles.selectedCoordinate();
  }
  /// Whether the selected handle is a corner of an object whose corners come and go: a polygon, a prism.
  [[nodiscard]] bool isCornerSelected() const { return m_edits.isCornerSelected(); }
  /// Puts a corner behind the selected one, or takes that away; where there are as many or as few as there
  /// may be, the hint says so.
  void addCorner() { m_edits.addCorner(); }
  void removeCorner() { m_edits.removeCorner(); }
  /// Ends what the mouse began, as its release does.
  void finishDrag() { m_input.finish(); }

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
  void resizeEvent(QResizeEvent *event) override;
  bool focusNextPrevChild(bool next) override;

private:
  [[nodiscard]] Screen screen() const;
  void followModel();
  void joinParts();
  void takeLesson();
  void takeOutcome();
  /// Whether what glides or fades is seen to do so.
  [[nodiscard]] bool moves() const { return m_motion && isVisible(); }
  void showNew();
  void showMoving();
  void tellHint() { emit hint(m_handles.hint()); }

  SessionModel &m_model;
  double m_sizeScale = 1;
  bool m_motion = true;
  Viewpoint m_viewpoint;
  DrawnFigure m_drawn;
  HandleHold m_hold;
  SceneHandles m_handles;
  HandleEdits m_edits;
  SceneInput m_input;
  SceneDrawing m_drawing;
};

} // namespace halfspace
