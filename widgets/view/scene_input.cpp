#include "widgets/view/scene_input.h"

#include "widgets/mouse_place.h"
#include "widgets/view/snapping_keys.h"

#include <QKeyEvent>
#include <QToolTip>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace halfspace {
namespace {

constexpr double radiansPerPixel = 0.005;
constexpr double zoomPerWheelStep = 0.88;
/// As Qt counts the angle of a wheel.
constexpr double anglePerWheelStep = 120;
/// Where no picture is.
constexpr glm::dvec2 nowhere{-1e6, -1e6};

/// The modifier that a key is; for other keys none.
Qt::KeyboardModifiers modifierOf(int key) {
  return key == Qt::Key_Control ? Qt::ControlModifier : key == Qt::Key_Alt ? Qt::AltModifier : Qt::NoModifier;
}

} // namespace

SceneInput::SceneInput(QWidget &view, const ViewScreen &screen, Viewpoint &viewpoint, SceneHandles &handles,
                       HandleEdits &edits, HandleHold &hold)
    : m_view(view), m_screen(screen), m_viewpoint(viewpoint), m_handles(handles), m_edits(edits),
      m_hold(hold), m_picture(viewpoint) {
  m_view.setMouseTracking(true);
  m_view.setFocusPolicy(Qt::StrongFocus);
  m_view.installEventFilter(this);
  connect(&m_hold, &HandleHold::caughtChanged, this, &SceneInput::showCaught);
  connect(&m_handles, &SceneHandles::canGrabChanged, this, [this](bool canGrab) {
    if (canGrab)
      m_view.setCursor(Qt::OpenHandCursor);
    else
      m_view.unsetCursor();
  });
}

bool SceneInput::eventFilter(QObject *watched, QEvent *event) {
  switch (event->type()) {
  case QEvent::MouseButtonPress:
  case QEvent::MouseButtonDblClick: // of two quick presses the second; to a handle it is one like any other
    press(static_cast<QMouseEvent &>(*event));
    return true;
  case QEvent::MouseMove:
    move(static_cast<QMouseEvent &>(*event));
    return true;
  case QEvent::MouseButtonRelease:
    release(static_cast<QMouseEvent &>(*event));
    return true;
  case QEvent::Wheel:
    turnWheel(static_cast<QWheelEvent &>(*event));
    event->accept();
    return true;
  case QEvent::KeyPress:
    return pressKey(static_cast<QKeyEvent &>(*event));
  case QEvent::KeyRelease:
    return releaseKey(static_cast<QKeyEvent &>(*event));
  case QEvent::ShortcutOverride:
    // While a handle is held all keys belong to the drag, before any shortcut of the window.
    if (m_gesture != Gesture::Handle)
      return false;
    event->accept();
    return true;
  case QEvent::Leave:
    leave();
    return false;
  default:
    return QObject::eventFilter(watched, event);
  }
}

void SceneInput::press(const QMouseEvent &event) {
  if (m_gesture != Gesture::None)
    return;
  m_viewpoint.stop();
  m_press.place = m_pointer = mousePlace(event);
  m_press.hasMoved = false;
  const bool shifted = event.modifiers() & Qt::ShiftModifier;
  if (event.button() != Qt::LeftButton)
    pressPicture(Gesture::Pan);
  else if (!pressHandle(m_press.place, shifted))
    pressPicture(shifted ? Gesture::Pan : Gesture::Turn);
  m_press.button = event.button(); // last: a gesture from elsewhere that ends here lets go of all
}

bool SceneInput::pressHandle(const QPointF &place, bool shifted) {
  const auto grab = m_isGrabbing ? m_handles.grabAt(m_screen.pixelAt(place), shifted) : std::nullopt;
  if (!grab)
    return false;
  m_hold.begin(grab->handle, grab->mode, m_screen.pixelAt(place));
  m_gesture = Gesture::Handle;
  m_press.wasOnSelected = m_handles.selection().selectedId() == grab->handle.id;
  m_view.setCursor(Qt::ClosedHandCursor);
  m_handles.select(grab->handle.id);
  return true;
}

void SceneInput::pressPicture(Gesture gesture) {
  m_gesture = gesture;
  m_picture.begin();
}

void SceneInput::move(const QMouseEvent &event) {
  const QPointF place = mousePlace(event);
  if (m_gesture == Gesture::None)
    return m_handles.hover(m_isGrabbing ? m_screen.pixelAt(place) : nowhere);
  if (!(event.buttons() & m_press.button))
    return finish(); // the release went elsewhere
  if ((place - m_press.place).manhattanLength() > clickSlop)
    m_press.hasMoved = true;
  if (!m_press.hasMoved)
    return;
  const QPointF way = place - std::exchange(m_pointer, place);
  if (m_gesture == Gesture::Handle)
    m_hold.pointTo(m_screen.pixelAt(place), suspendsSnapping(event.modifiers()));
  else
    movePicture(way);
}

void SceneInput::movePicture(const QPointF &way) {
  if (m_gesture == Gesture::Turn)
    m_picture.turn(-way.x() * radiansPerPixel, way.y() * radiansPerPixel);
  else
    m_picture.pan(m_screen.pixelAt(way));
}

void SceneInput::release(const QMouseEvent &event) {
  if (event.button() != m_press.button)
    return;
  const bool isClick = m_isGrabbing && !m_press.hasMoved &&
                       (event.button() == Qt::LeftButton || event.button() == Qt::RightButton);
  const bool isClickBeside = isClick && m_gesture == Gesture::Turn;
  const QString mark =
      isClick ? QString::fromStdString(m_handles.markAt(m_screen.pixelAt(m_press.place))) : QString();
  finish();
  if (isClickBeside)
    dismiss();
  if (isClick && event.button() == Qt::RightButton)
    emit menuWanted(mark);
  else if (isClick)
    emit clicked(mark, event.modifiers() & Qt::ControlModifier);
}

void SceneInput::finish() {
  if (m_gesture == Gesture::None)
    return;
  if (m_gesture == Gesture::Handle) {
    m_hold.follow(m_viewpoint.view());
    m_hold.end(m_press.hasMoved);
    if (!m_press.hasMoved && m_press.wasOnSelected)
      m_handles.switchDirection();
  }
  letGo();
}

void SceneInput::letGo() {
  m_hold.letGo();
  m_gesture = Gesture::None;
  m_press.button = Qt::NoButton;
  m_view.unsetCursor();
  m_handles.settle();
}

void SceneInput::setGrabbing(bool grabbing) {
  finish();
  m_isGrabbing = grabbing;
  m_handles.select({});
  m_handles.hover(nowhere);
}

void SceneInput::turnWheel(const QWheelEvent &event) {
  const double steps = event.angleDelta().y() / anglePerWheelStep;
  m_picture.zoom(std::pow(zoomPerWheelStep, steps), m_screen.pixelAt(event.position()));
}

void SceneInput::leave() {
  if (m_gesture == Gesture::None)
    m_handles.hover(nowhere);
}

bool SceneInput::pressKey(const QKeyEvent &event) {
  const int key = event.key();
  if (key == Qt::Key_Escape && m_gesture == Gesture::Handle) {
    m_hold.end(false);
    letGo();
    return true;
  }
  if (key == Qt::Key_Escape) {
    dismiss();
    return true;
  }
  if (m_hold.isHolding() && suspendsSnapping(modifierOf(key))) {
    m_hold.setSuspended(true);
    return true;
  }
  if (key == Qt::Key_Shift && m_hold.mode() == DragMode::Horizontal) {
    m_hold.setMode(DragMode::Vertical);
    return true;
  }
  if (event.modifiers() == Qt::NoModifier && lockAxis(key))
    return true;
  return m_gesture == Gesture::None && m_edits.step(key, event.modifiers());
}

bool SceneInput::releaseKey(const QKeyEvent &event) {
  const int key = event.key();
  if (m_hold.isHolding() && suspendsSnapping(modifierOf(key))) {
    m_hold.setSuspended(suspendsSnapping(event.modifiers() & ~modifierOf(key)));
    return true;
  }
  if (key != Qt::Key_Shift || m_hold.mode() != DragMode::Vertical || m_handles.selection().isVertical())
    return false;
  m_hold.setMode(DragMode::Horizontal);
  return true;
}

bool SceneInput::lockAxis(int key) {
  const int axis = key == Qt::Key_X ? 0 : key == Qt::Key_Y ? 1 : key == Qt::Key_Z ? 2 : -1;
  if (axis < 0 || !m_hold.isHolding())
    return false;
  static const DragMode modes[3] = {DragMode::AxisX, DragMode::AxisY, DragMode::AxisZ};
  m_hold.setMode(m_hold.mode() == modes[axis] ? DragMode::Horizontal : modes[axis]);
  return true;
}

void SceneInput::dismiss() {
  m_handles.select({});
  emit dismissed();
}

void SceneInput::showCaught() {
  QToolTip::showText(m_view.mapToGlobal(m_pointer.toPoint()), QString::fromStdString(m_hold.caught()),
                     &m_view);
}

} // namespace halfspace
