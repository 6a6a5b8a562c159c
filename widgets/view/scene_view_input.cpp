// The scene view's mouse and keys.
#include "lessons/object/corners.h"
#include "lessons/scene/change_words.h"
#include "lessons/scene/hand/snapping.h"
#include "widgets/mouse_place.h"
#include "widgets/picture/shapes/gizmo_shape.h"
#include "widgets/view/key_steps.h"
#include "widgets/view/scene_view.h"

#include <QKeyEvent>
#include <QToolTip>

#include <algorithm>

namespace halfspace {
namespace {

using Clock = std::chrono::steady_clock;

/// A press that moves less than this many pixels is a click.
constexpr int clickSlop = 3;

/// Who has dragged so many handles needs no words about it any more.
constexpr int dragsToLearn = 3;

/// A handle that moves up and down does so with the arrow keys too.
int verticalKey(int key) {
  return key == Qt::Key_Up ? Qt::Key_PageUp : key == Qt::Key_Down ? Qt::Key_PageDown : key;
}

/// Whether snapping is suspended while one of these keys is held. Alt too, where the window manager leaves it
/// to us.
bool suspends(Qt::KeyboardModifiers held) { return held & (Qt::ControlModifier | Qt::AltModifier); }

/// The modifier that a key is; for other keys none.
Qt::KeyboardModifiers modifierOf(int key) {
  return key == Qt::Key_Control ? Qt::ControlModifier : key == Qt::Key_Alt ? Qt::AltModifier : Qt::NoModifier;
}

/// What can be done with a handle that moves like this, from where it is seen.
QString hintFor(DragMode mode, const Handle &handle, const Camera &camera) {
  switch (mode) {
  case DragMode::Horizontal:
    if (grabMode(handle, true, camera) != DragMode::Vertical)
      return SceneView::tr("Moves in x and y. Look from the side to move it up and down.");
    return SceneView::tr("Moves in x and y. Click it again, or hold Shift, for up and down. X, Y, Z lock an "
                         "axis. Ctrl frees it from the grid.");
  case DragMode::Vertical:
    if (grabMode(handle, false, camera) != DragMode::Horizontal)
      return SceneView::tr("Moves up and down. Look from higher above to move it in x and y.");
    return SceneView::tr("Moves up and down. Click it again for x and y.");
  case DragMode::AxisX:
    return SceneView::tr("Moves along x only.");
  case DragMode::AxisY:
    return SceneView::tr("Moves along y only.");
  case DragMode::AxisZ:
    return SceneView::tr("Moves along z only.");
  case DragMode::PlaneYZ:
    return SceneView::tr("Moves in y and z.");
  case DragMode::PlaneZX:
    return SceneView::tr("Moves in x and z.");
  case DragMode::OwnAxis:
    return SceneView::tr("Moves along its line only.");
  case DragMode::OwnPlane:
    return SceneView::tr("Moves in its plane only.");
  case DragMode::OwnSphere:
    break;
  }
  return SceneView::tr("Moves on its sphere only.");
}

/// The handle that moves the surface of very many triangles with this mark; null for other marks. Its own
/// place may lie hidden inside.
const Handle *handleOfBody(const std::string &mark, const Figure &figure,
                           const std::vector<Handle> &handles) {
  const bool isBody = std::any_of(figure.marks.begin(), figure.marks.end(), [&](const Mark &each) {
    return std::holds_alternative<MeshMark>(each) && baseOf(each).id == mark;
  });
  const auto found = std::find_if(handles.begin(), handles.end(), [&](const Handle &handle) {
    return handle.object == mark && handle.motion == Handle::Motion::Coordinate && isZero(handle.base);
  });
  return isBody && found != handles.end() ? &*found : nullptr;
}

} // namespace

bool SceneView::event(QEvent *event) {
  // While a handle is held all keys belong to the drag, before any shortcut of the window.
  if (event->type() == QEvent::ShortcutOverride && m_gesture == Gesture::Handle) {
    event->accept();
    return true;
  }
  return QVTKOpenGLNativeWidget::event(event);
}

void SceneView::showEvent(QShowEvent *event) {
  window()->installEventFilter(this);
  QVTKOpenGLNativeWidget::showEvent(event);
}

bool SceneView::eventFilter(QObject *watched, QEvent *event) {
  if (event->type() == QEvent::UpdateRequest && m_contentStale)
    frame();
  return QVTKOpenGLNativeWidget::eventFilter(watched, event);
}

void SceneView::mousePressEvent(QMouseEvent *event) {
  if (m_gesture != Gesture::None)
    return;
  m_glide.stop();
  m_pressed = m_lastPointer = mousePlace(*event);
  m_moved = false;
  if (event->button() != Qt::LeftButton)
    pressPicture(Gesture::Pan);
  else if (!pressTool(devicePixel(m_pressed), event->modifiers()))
    pressPicture(event->modifiers() & Qt::ShiftModifier ? Gesture::Pan : Gesture::Turn);
  m_button = event->button(); // last: a gesture from elsewhere that ends here lets go of all
}

bool SceneView::pressTool(glm::dvec2 pixel, Qt::KeyboardModifiers modifiers) {
  const bool shifted = modifiers & Qt::ShiftModifier;
  const Hold hold = holdAt(pixel);
  if (hold.part) {
    pressHandle(*findHandle(m_selected), modeOf(*hold.part), pixel);
    return true;
  }
  const Handle *handle = hold.handle;
  bool vertical = shifted;
  if (handle && handle->id == m_selected)
    vertical = m_vertical != shifted;
  else if (!handle)
    handle = handleOfBody(m_composer.markAt(pixel), m_figure, m_handles);
  const auto mode = handle ? grabMode(*handle, vertical, m_camera) : std::nullopt;
  if (!mode)
    return false;
  pressHandle(*handle, *mode, pixel);
  return true;
}

SceneView::Hold SceneView::holdAt(glm::dvec2 pixel) const {
  if (const Handle *handle = handleAt(pixel, grabMargin))
    return {handle, {}};
  if (const auto part = gizmoPartUnder(pixel); part && findHandle(m_selected))
    return {nullptr, part};
  return {handleAt(pixel, missMargin), {}};
}

void SceneView::pressPicture(Gesture gesture) {
  m_gesture = gesture;
  std::vector<Place> places = placesOf(m_figure);
  for (const Handle &handle : m_handles)
    places.push_back(shownPlace(handle));
  m_pivot = middleInView(screen(), places);
}

void SceneView::mouseDoubleClickEvent(QMouseEvent *event) {
  // Of two quick presses Qt delivers the second only as a double click: to a handle it is a press like any
  // other.
  mousePressEvent(event);
}

void SceneView::pressHandle(const Handle &pressed, DragMode mode, glm::dvec2 pixel) {
  const Handle handle = pressed; // the handles are made anew where another gesture ends
  const Scene &scene = m_model.session().scene;
  m_held = m_model.beginGesture(QString::fromStdString(wordsForMoving(scene, handle)));
  m_gesture = Gesture::Handle;
  m_fade.finish();
  m_drag.emplace(stagedScene(), handle, mode, pixel, m_model.askedOf(handle));
  if (m_selected != handle.id)
    m_vertical = false;
  const bool wasSelected = m_selected == handle.id;
  m_selected = handle.id;
  m_clickToggles = wasSelected;
  setCursor(Qt::ClosedHandCursor);
  updateContent();
  showHint();
  emit selectionChanged();
}

void SceneView::mouseMoveEvent(QMouseEvent *event) {
  if (m_gesture == Gesture::None)
    return hover(devicePixel(mousePlace(*event)));
  if (!(event->buttons() & m_button)) {
    // The release went elsewhere.
    finishDrag();
    return;
  }
  if (!m_moved && (mousePlace(*event) - m_pressed).manhattanLength() > clickSlop) {
    m_moved = true;
    if (m_gesture != Gesture::Handle)
      m_previousViews.remember(m_camera);
  }
  if (!m_moved)
    return;
  if (m_gesture == Gesture::Handle) {
    m_isSuspended = suspends(event->modifiers());
    m_pendingPointer = mousePlace(*event);
    showMoved();
  } else {
    moveCamera(mousePlace(*event));
  }
}

void SceneView::mouseReleaseEvent(QMouseEvent *event) {
  if (event->button() != m_button)
    return;
  const bool isClickBeside = m_gesture == Gesture::Turn && !m_moved;
  finishDrag();
  if (isClickBeside)
    dismiss();
}

void SceneView::followPointer() {
  if (!m_drag || !m_pendingPointer)
    return;
  m_lastPointer = *m_pendingPointer;
  m_pendingPointer.reset();
  const auto start = Clock::now();
  const bool isFree = m_isSuspended || !m_model.isSnapping();
  const auto move =
      m_drag->moveTo(devicePixel(m_lastPointer), isFree ? finestStep : m_model.snapStep(), screen());
  if (!move)
    return;
  m_outcomeTaken = start;
  m_model.moveGesture(m_held, ChangeObject{m_drag->handle().object, fromStage(move->object, m_stage)});
  if (m_outcomeTaken != start) {
    m_times.evaluate = m_outcomeTaken - start;
    m_times.panels = Clock::now() - m_outcomeTaken;
  }
  showCaught(move->caught);
  m_contentStale = true;
}

void SceneView::showCaught(const std::string &caught) {
  if (caught == m_caught)
    return;
  m_caught = caught;
  QToolTip::showText(mapToGlobal(m_lastPointer.toPoint()), QString::fromStdString(m_caught), this);
  showHint();
}

void SceneView::finishDrag() {
  if (m_gesture == Gesture::None)
    return;
  if (m_gesture == Gesture::Handle) {
    followPointer();
    if (m_moved) {
      ++m_dragsDone;
      m_model.endGesture(m_held);
    } else {
      m_model.cancelGesture(m_held);
    }
    if (!m_moved && m_clickToggles)
      m_vertical = !m_vertical;
  }
  letGo();
}

void SceneView::cancelDrag() {
  m_model.cancelGesture(m_held);
  letGo();
}

void SceneView::letGo() {
  m_drag.reset();
  m_handles = handlesOf(stagedScene()); // those that kept still under the hand go where they belong
  showCaught({});                       // what is typed or undone next may make it untrue
  m_pendingPointer.reset();
  m_gesture = Gesture::None;
  m_button = Qt::NoButton;
  unsetCursor();
  updateContent();
  showHint();
}

std::optional<Gizmo::Part> SceneView::gizmoPartUnder(glm::dvec2 pixel) const {
  const auto tool = gizmo();
  return tool ? gizmoPartAt(*tool, m_camera, pixelSize(), designRatio(), pixel) : std::nullopt;
}

void SceneView::hover(glm::dvec2 pixel) {
  const auto [handle, part] = holdAt(pixel);
  const std::string handleId = handle ? handle->id : std::string();
  const std::string mark = handle ? markOf(*handle) : part ? std::string() : m_composer.markAt(pixel);
  if (part == m_hotPart && handleId == m_hovered && mark == m_hoveredMark)
    return;
  m_hotPart = part;
  m_hovered = handleId;
  if (handle || part || handleOfBody(mark, m_figure, m_handles))
    setCursor(Qt::OpenHandCursor);
  else
    unsetCursor();
  if (mark != m_hoveredMark) {
    m_hoveredMark = mark;
    emit markHovered(QString::fromStdString(mark));
  }
  updateContent();
}

void SceneView::leaveEvent(QEvent *event) {
  if (m_gesture == Gesture::None)
    hover({-1e6, -1e6});
  QVTKOpenGLNativeWidget::leaveEvent(event);
}

void SceneView::setDragMode(DragMode mode) {
  if (!m_drag || isOwn(m_drag->mode()))
    return;
  m_drag->setMode(mode);
  updateContent();
  showHint();
}

bool SceneView::lockAxis(int key) {
  const int axis = key == Qt::Key_X ? 0 : key == Qt::Key_Y ? 1 : key == Qt::Key_Z ? 2 : -1;
  if (axis < 0 || !m_drag)
    return false;
  static const DragMode modes[3] = {DragMode::AxisX, DragMode::AxisY, DragMode::AxisZ};
  setDragMode(m_drag->mode() == modes[axis] ? DragMode::Horizontal : modes[axis]);
  return true;
}

void SceneView::keyPressEvent(QKeyEvent *event) {
  if (event->key() == Qt::Key_Escape) {
    if (m_gesture == Gesture::Handle)
      cancelDrag();
    else
      dismiss();
    return;
  }
  if (m_drag && suspends(modifierOf(event->key())))
    return setSuspended(true);
  if (event->key() == Qt::Key_Shift && m_drag && m_drag->mode() == DragMode::Horizontal)
    return setDragMode(DragMode::Vertical);
  if ((event->modifiers() == Qt::NoModifier && lockAxis(event->key())) || stepSelected(*event))
    return;
  QVTKOpenGLNativeWidget::keyPressEvent(event);
}

void SceneView::dismiss() {
  selectHandle({});
  emit dismissed();
}

void SceneView::setSuspended(bool suspended) {
  m_isSuspended = suspended;
  if (!m_moved)
    return;
  m_pendingPointer = m_lastPointer;
  showMoved();
}

void SceneView::keyReleaseEvent(QKeyEvent *event) {
  if (m_drag && suspends(modifierOf(event->key())))
    return setSuspended(suspends(event->modifiers() & ~modifierOf(event->key())));
  if (event->key() == Qt::Key_Shift && m_drag && m_drag->mode() == DragMode::Vertical && !m_vertical)
    return setDragMode(DragMode::Horizontal);
  QVTKOpenGLNativeWidget::keyReleaseEvent(event);
}

bool SceneView::stepSelected(const QKeyEvent &event) {
  const Handle *handle = findHandle(m_selected);
  const Scene scene = handle ? stagedScene().scene : Scene();
  const Object *object = handle ? findObject(scene, handle->object) : nullptr;
  if (!object || m_gesture != Gesture::None)
    return false;
  const auto place = steppedPlace(*handle, m_vertical ? verticalKey(event.key()) : event.key(),
                                  event.modifiers(), m_model.snapStep(), m_camera);
  if (!place)
    return false;
  // On a plane or a ball the place is brought back to it; with half the step as a grid no press is lost.
  const ExactVec3 way = *place - handle->at;
  const Rational halfStep = (abs(way.x) + abs(way.y) + abs(way.z)) / 2;
  const bool isOnSurface = handle->host && !handle->hasAxis();
  const Object moved =
      isOnSurface ? movedToGrid(*object, *handle, *place, halfStep) : movedTo(*object, *handle, *place);
  showRefusal(m_model.edit(ChangeObject{handle->object, fromStage(moved, m_stage)},
                           QString::fromStdString(wordsForMoving(m_model.session().scene, *handle))));
  return true;
}

bool SceneView::showRefusal(const QString &sentence) {
  if (!sentence.isEmpty())
    emit hint(sentence);
  return !sentence.isEmpty();
}

const Object *SceneView::objectOfSelected() const {
  const Handle *handle = findHandle(m_selected);
  return handle && handle->motion == Handle::Motion::Coordinate
             ? findObject(m_model.session().scene, handle->object)
             : nullptr;
}

bool SceneView::isCornerSelected() const {
  const Object *object = objectOfSelected();
  const auto corners = object ? cornersOf(*object) : std::vector<std::size_t>();
  return object && std::binary_search(corners.begin(), corners.end(), findHandle(m_selected)->coordinate);
}

void SceneView::addCorner() {
  if (!isCornerSelected())
    return;
  const Handle handle = *findHandle(m_selected);
  const Object &object = *objectOfSelected();
  if (!canAddCornerAfter(object, handle.coordinate)) {
    emit hint(tr("It has %n corners, as many as there can be.", nullptr,
                 static_cast<int>(cornersOf(object).size())));
    return;
  }
  const Object more = withCornerAfter(object, handle.coordinate);
  if (showRefusal(m_model.edit(ChangeObject{handle.object, more}, tr("Add a corner"))))
    return;
  const auto corners = cornersOf(more);
  selectHandle(coordinateId(
      handle.object,
      coordinatesOf(more)[*std::upper_bound(corners.begin(), corners.end(), handle.coordinate)]));
}

void SceneView::removeCorner() {
  if (!isCornerSelected())
    return;
  const Handle handle = *findHandle(m_selected);
  const Object &object = *objectOfSelected();
  if (!canRemoveCorner(object, handle.coordinate)) {
    emit hint(tr("It has %n corners, as few as there can be.", nullptr,
                 static_cast<int>(cornersOf(object).size())));
    return;
  }
  showRefusal(m_model.edit(ChangeObject{handle.object, withoutCorner(object, handle.coordinate)},
                           tr("Remove a corner")));
}

void SceneView::showHint() {
  const Handle *handle = findHandle(m_selected);
  if (!m_caught.empty())
    emit hint(QString::fromStdString(m_caught));
  else if (m_hasTypedAway)
    emit hint(tr("What was typed lies outside of the view. F brings all into it."));
  else if (!handle && !m_stage.hasAxes())
    emit hint(tr("The origin and the axes lie far outside of this picture."));
  else if (!handle)
    emit hint(m_dragsDone < dragsToLearn
                  ? tr("Drag a handle to move it, drag beside it to turn the view. The wheel zooms.")
                  : QString());
  else if (const auto mode = m_drag ? std::optional(m_drag->mode()) : grabMode(*handle, m_vertical, m_camera))
    emit hint(hintFor(*mode, *handle, m_camera));
  else
    emit hint(tr("Turn the view: from here this handle is seen end-on."));
}

} // namespace halfspace
