// The handles of a view's scene: which is selected or hovered, and what is drawn and told of that.
#pragma once

#include "widgets/picture/hand/handle_tools.h"
#include "widgets/view/drawn_figure.h"
#include "widgets/view/handle_hold.h"
#include "widgets/view/viewpoint.h"

#include <functional>

namespace halfspace {

/// Follows the scene of a session. What is drawn of the handles, and what can be done with them, depends on
/// where the view's camera stands. Pixels are those of the device.
class SceneHandles : public QObject {
  Q_OBJECT

public:
  /// `markAt` tells the id of the mark that is seen at a pixel, or empty. Nothing here takes hold of
  /// anything, but what `hold` holds stays where it is.
  SceneHandles(SessionModel &model, Viewpoint &viewpoint, const DrawnFigure &drawn, const HandleHold &hold,
               std::function<std::string(glm::dvec2)> markAt);

  void setTheme(const Theme &theme) { m_theme = theme; }
  void takeLesson();
  void takeOutcome();
  /// Those that kept still under the hand go where they belong.
  void settle();

  [[nodiscard]] const HandleSelection &selection() const { return m_selection; }
  /// The coordinate of the selected handle, or the first of its object where it moves more than one.
  [[nodiscard]] std::optional<CoordinateId> selectedCoordinate() const;
  void select(const std::string &id);
  /// Selects the next handle in their order, or the first; behind the last none, and it is false.
  bool selectNext(bool forward);
  /// The selected handle moves up and down when it is grabbed, or in x and y again.
  void switchDirection() { m_selection.switchDirection(); }

  /// The id of the mark at a pixel, or of that of the handle there; empty for none.
  [[nodiscard]] std::string markAt(glm::dvec2 pixel) const;
  /// What lies under the pointer now.
  void hover(glm::dvec2 pixel);
  /// A handle, and how a press grabs it.
  struct Grab {
    Handle handle;
    DragMode mode;
  };
  /// What a press at a pixel would grab, up and down instead of in x and y with `shifted`; nothing for none.
  [[nodiscard]] std::optional<Grab> grabAt(glm::dvec2 pixel, bool shifted) const;

  /// The tool of the selected handle.
  [[nodiscard]] std::optional<Gizmo> gizmo() const;
  [[nodiscard]] std::vector<Knob> knobs() const { return knobsOf(m_selection, m_viewpoint.camera()); }
  /// Adds to what is drawn all that is drawn of handles.
  void addTo(SceneContent &content) const;
  /// What can be done with the selected handle, or what a drag just snapped to.
  [[nodiscard]] QString hint() const;

signals:
  void changed(); ///< of what is drawn
  void hintChanged();
  void selectionChanged();                 ///< of a handle, or of what can be done with it
  void markHovered(const QString &markId); ///< empty: none
  void canGrabChanged(bool canGrab);       ///< what the pointer is over

private:
  [[nodiscard]] std::vector<Grip> grips() const;
  [[nodiscard]] Touched touchedAt(glm::dvec2 pixel) const;
  [[nodiscard]] std::string markOf(const Handle &handle) const;
  void takeHandles();
  /// Those after an edit that is no gesture, or of another lesson.
  void takeOthers();

  SessionModel &m_model;
  Viewpoint &m_viewpoint;
  const DrawnFigure &m_drawn;
  const HandleHold &m_hold;
  std::function<std::string(glm::dvec2)> m_markAt;
  Theme m_theme;
  HandleSelection m_selection;
  std::optional<Gizmo::Part> m_hotPart;
  std::string m_hoveredMark;
};

} // namespace halfspace
