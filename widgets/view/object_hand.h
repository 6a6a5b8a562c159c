// A tool in the hand that makes objects in the 3D view.
#pragma once

#include "widgets/picture/hand/tool_pick.h"
#include "widgets/view/drawn_figure.h"
#include "widgets/view/scene_input.h"

namespace halfspace {

class PointerHint;

/// While it has a tool, clicks take points for that and the keys move the would-be point, before the view
/// itself gets them; the picture is turned, moved and zoomed as always. What would come is drawn as a ghost,
/// and what is wanted next stands beside the pointer. All that the tool makes is one step of the history;
/// then the hand is empty again.
class ObjectHand : public QObject {
  Q_OBJECT

public:
  /// The others must outlive it.
  ObjectHand(QWidget &view, const ViewScreen &screen, Viewpoint &viewpoint, SessionModel &model,
             DrawnFigure &drawn, SceneInput &input);

  /// Takes a tool into the hand, in the place of one that it has, and the keys to the view.
  void begin(ToolObject object);
  /// Puts the tool away. Nothing comes of it.
  void cancel();
  /// What is being made; nothing while the hand is empty.
  [[nodiscard]] std::optional<ToolObject> tool() const;
  /// What the tool wants next, in words; empty without one.
  [[nodiscard]] QString prompt() const;

  /// The model shows another scene, and the figure is that of it: the tool goes on as far as what it has
  /// taken is still there.
  void takeOutcome();

signals:
  void toolChanged();                      ///< the hand has taken a tool, or put it away
  void promptChanged();                    ///< another thing is wanted, or nothing any more
  void markHovered(const QString &markId); ///< what a click would take; empty: nothing that is there
  void refused(const QString &sentence);   ///< why nothing came of it

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  struct Pointer {
    QPointF place;
    bool isSuspended = false; ///< whether keys suspend snapping
  };
  struct Press {
    Qt::MouseButton button = Qt::NoButton;
    QPointF place;
    bool hasMoved = false; ///< whether the pointer has left the place
  };

  void press(const QMouseEvent &event);
  void move(const QMouseEvent &event);
  void release(const QMouseEvent &event);
  /// False for a key that means nothing here.
  bool pressKey(const QKeyEvent &event);
  /// Moves the would-be point; false for a key that moves nothing.
  bool stepPlace(const QKeyEvent &event);
  /// While Shift is held a point of a plane moves up and down instead, from where it is, and the other way
  /// round.
  void turnRoom(bool turned);
  /// Where the would-be point is, in units of the stage.
  [[nodiscard]] ExactVec3 nextPlace() const;
  /// Takes what lies under the pointer, from where the view is seen now.
  void aim();
  void setNext(std::optional<ToolPick> next);
  void takeNext();
  /// With one thing more: makes the object if that was the last.
  void goOn(ObjectTool tool);
  void stepBack();
  void go(ObjectTool tool);
  void make(const ObjectTool &tool);
  void show();
  [[nodiscard]] ToolScene toolScene() const;

  QWidget &m_view;
  const ViewScreen &m_screen;
  Viewpoint &m_viewpoint;
  SessionModel &m_model;
  DrawnFigure &m_drawn;
  SceneInput &m_input;
  PointerHint *m_hint;
  std::optional<ObjectTool> m_tool;
  ToolRoom m_room;                  ///< where a new point would be
  std::optional<ToolPick> m_next;   ///< what a click would take
  std::optional<Pointer> m_pointer; ///< nothing while it is elsewhere, or keys have moved the would-be point
  Press m_press;
};

} // namespace halfspace
