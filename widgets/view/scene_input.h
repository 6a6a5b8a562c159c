// The mouse and the keys over a view.
#pragma once

#include "widgets/view/handle_edits.h"
#include "widgets/view/picture_hold.h"
#include "widgets/view/view_screen.h"

#include <QWidget>

class QKeyEvent;
class QMouseEvent;
class QWheelEvent;

namespace halfspace {

/// Takes the events of a view before the view itself does, and turns them into what the hand does: it hovers
/// over handles, holds one, or turns and moves the picture. What it has no use for goes on to the view.
class SceneInput : public QObject {
  Q_OBJECT

public:
  /// A press that moves less than this many pixels is a click.
  static constexpr int clickSlop = 3;

  SceneInput(QWidget &view, const ViewScreen &screen, Viewpoint &viewpoint, SceneHandles &handles,
             HandleEdits &edits, HandleHold &hold);

  /// Ends what the mouse began, as its release does.
  void finish();
  /// Forgets what the mouse holds.
  void letGo();
  /// Whether the mouse hovers over handles, grabs and dismisses them; else it has the picture alone. What it
  /// had of handles ends.
  void setGrabbing(bool grabbing);

signals:
  void dismissed(); ///< Escape, or a click beside the handles, while nothing is dragged
  /// The left button was pressed and released in one place: on this mark, or on none (empty). `adds` with
  /// Ctrl.
  void clicked(const QString &markId, bool adds);
  void menuWanted(const QString &markId); ///< the same with the right button

protected:
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  enum class Gesture { None, Turn, Pan, Handle };
  struct Press {
    Qt::MouseButton button = Qt::NoButton;
    QPointF place;
    bool hasMoved = false;      ///< whether the pointer has left the place
    bool wasOnSelected = false; ///< whether it was on the handle that was selected already
  };

  void press(const QMouseEvent &event);
  /// Takes hold of the handle or the part of the tool at a place, if there is one.
  bool pressHandle(const QPointF &place, bool shifted);
  void pressPicture(Gesture gesture);
  void move(const QMouseEvent &event);
  void movePicture(const QPointF &way);
  void release(const QMouseEvent &event);
  void turnWheel(const QWheelEvent &event);
  void leave();
  /// Of keys, false: they mean nothing here.
  bool pressKey(const QKeyEvent &event);
  bool releaseKey(const QKeyEvent &event);
  bool lockAxis(int key);
  void dismiss();
  void showCaught();

  QWidget &m_view;
  const ViewScreen &m_screen;
  Viewpoint &m_viewpoint;
  SceneHandles &m_handles;
  HandleEdits &m_edits;
  HandleHold &m_hold;
  PictureHold m_picture;
  bool m_isGrabbing = true;
  Gesture m_gesture = Gesture::None;
  Press m_press;     ///< that began it
  QPointF m_pointer; ///< the newest place
};

} // namespace halfspace
