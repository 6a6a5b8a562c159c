#include "widgets/scene_view.h"

#include "lessons/formula.h"
#include "widgets/key_steps.h"
#include "widgets/scene/gizmo_shape.h"
#include "widgets/scene/render_window.h"
#include "widgets/views.h"

#include <QGuiApplication>
#include <QKeyEvent>
#include <QMouseEvent>

#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

using Clock = std::chrono::steady_clock;

/// A handle is grabbed within this many design pixels.
constexpr double grabDistance = 11;
/// A press that moves less than this many pixels is a click.
constexpr int clickSlop = 3;
/// What moves is drawn without smoothing until it has rested for so long, in milliseconds.
constexpr int restDelay = 160;
constexpr int glideTime = 350;
/// Samples a pixel at rest; while something moves there is one.
constexpr int restSamples = 4;
constexpr double radiansPerPixel = 0.008;
constexpr double zoomPerWheelStep = 0.88;

/// The finest step of all, to which Alt suspends snapping.
const Rational finestStep(1, 1000);

/// What can be done with a handle that moves like this.
QString hintFor(DragMode mode) {
  switch (mode) {
  case DragMode::Horizontal:
    return SceneView::tr(
        "Moves in x and y. Click it again or hold Shift for up and down; X, Y, Z lock an axis.");
  case DragMode::Vertical:
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
    break;
  }
  return SceneView::tr("Moves the plane along its normal.");
}

} // namespace

SceneView::SceneView(SessionModel &model, LabelPainter labels, QWidget *parent)
    : QVTKOpenGLNativeWidget(parent), m_model(model), m_scene(std::move(labels)), m_theme(themes().front()),
      m_camera(model.lesson().camera) {
  vtkNew<halfspace::RenderWindow> window;
  setRenderWindow(window);
  window->AddRenderer(m_scene.renderer());
  // VTK's own interaction would fight with ours.
  window->GetInteractor()->SetInteractorStyle(nullptr);

  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("3D scene"));
  m_frameTimer.setSingleShot(true);
  m_restTimer.setSingleShot(true);
  m_restTimer.setInterval(restDelay);
  connect(&m_frameTimer, &QTimer::timeout, this, &SceneView::frame);
  connect(&m_restTimer, &QTimer::timeout, this, &SceneView::requestFrame);
  connect(&m_model, &SessionModel::lessonChanged, this, [this] {
    selectHandle({});
    goHome();
  });
  connect(&m_model, &SessionModel::outcomeChanged, this, &SceneView::takeOutcome);
  takeOutcome();
}

SceneView::~SceneView() {
  makeCurrent();
  renderWindow()->RemoveRenderer(m_scene.renderer());
  doneCurrent();
}

void SceneView::setTheme(const Theme &theme) {
  m_theme = theme;
  m_scene.setTheme(theme);
  requestFrame();
}

void SceneView::setHighlighted(std::set<std::string> markIds) {
  m_highlighted = std::move(markIds);
  updateContent();
}

PixelSize SceneView::pixelSize() const {
  const double ratio = devicePixelRatioF();
  return {std::max(1, static_cast<int>(std::lround(width() * ratio))),
          std::max(1, static_cast<int>(std::lround(height() * ratio)))};
}

glm::dvec2 SceneView::devicePixel(const QPointF &position) const {
  return glm::dvec2(position.x(), position.y()) * devicePixelRatioF();
}

DragScreen SceneView::screen() const { return {m_camera, pixelSize(), devicePixelRatioF()}; }

// --- handles
// -------------------------------------------------------------------------------------------------------

const Handle *SceneView::findHandle(const std::string &id) const {
  const auto found =
      std::find_if(m_handles.begin(), m_handles.end(), [&](const Handle &h) { return h.id == id; });
  return found == m_handles.end() ? nullptr : &*found;
}

const Handle *SceneView::handleAt(glm::dvec2 pixel) const {
  const Handle *nearest = nullptr;
  double least = grabDistance * devicePixelRatioF();
  for (const Handle &handle : m_handles) {
    const auto projected = m_camera.project(shownPlace(handle), pixelSize());
    if (!projected || !grabMode(handle, m_vertical, m_camera))
      continue;
    const double distance = glm::length(glm::dvec2(*projected) - pixel);
    // Of two at the same pixel the later one wins: a tip lies over the point that it starts from.
    if (distance <= least) {
      least = distance;
      nearest = &handle;
    }
  }
  return nearest;
}

std::optional<QPoint> SceneView::handlePosition(const std::string &handleId) const {
  const Handle *handle = findHandle(handleId);
  if (!handle)
    return {};
  const auto projected = m_camera.project(shownPlace(*handle), pixelSize());
  if (!projected)
    return {};
  const double ratio = devicePixelRatioF();
  const QPoint position(static_cast<int>(std::lround(projected->x / ratio)),
                        static_cast<int>(std::lround(projected->y / ratio)));
  return rect().contains(position) ? std::optional(position) : std::nullopt;
}

std::string SceneView::markOf(const Handle &handle) const {
  if (handle.motion != Handle::Motion::Coordinate)
    return handle.object;
  return shortName(m_model.session().scene, {handle.object, handle.coordinate});
}

void SceneView::selectHandle(const std::string &handleId) {
  if (m_selected != handleId)
    m_vertical = false;
  m_selected = handleId;
  updateContent();
  showHint();
}

void SceneView::selectNext(bool forward) {
  if (m_handles.empty())
    return;
  const auto count = m_handles.size();
  const Handle *selected = findHandle(m_selected);
  const std::size_t index =
      selected ? static_cast<std::size_t>(selected - m_handles.data()) : (forward ? count - 1 : 0);
  selectHandle(m_handles[(index + (forward ? 1 : count - 1)) % count].id);
}

bool SceneView::focusNextPrevChild(bool next) {
  // Tab goes from handle to handle; behind the last one it leaves the view.
  const Handle *selected = findHandle(m_selected);
  const bool atEnd = selected && (next ? selected == &m_handles.back() : selected == &m_handles.front());
  if (m_handles.empty() || atEnd) {
    selectHandle({});
    return QVTKOpenGLNativeWidget::focusNextPrevChild(next);
  }
  selectNext(next);
  return true;
}

// --- what is shown
// -------------------------------------------------------------------------------------------------

void SceneView::takeOutcome() {
  m_handles = handlesOf(m_model.session().scene);
  if (!findHandle(m_selected))
    m_selected.clear();
  if (!findHandle(m_hovered))
    m_hovered.clear();
  updateContent();
}

void SceneView::updateContent() {
  m_contentStale = true;
  requestFrame();
}

std::optional<Gizmo> SceneView::gizmo() const {
  const Handle *handle = findHandle(m_selected);
  if (!handle)
    return {};
  Gizmo gizmo;
  gizmo.at = shownPlace(*handle);
  gizmo.hot = m_hotPart;
  const auto mode = m_drag ? std::optional(m_drag->mode()) : grabMode(*handle, m_vertical, m_camera);
  if (!mode)
    return gizmo;
  if (handle->motion == Handle::Motion::AlongNormal) {
    gizmo.axes = false;
    gizmo.axis = toDouble(handle->axis);
  }
  static const std::pair<DragMode, Gizmo::Mode> modes[] = {
      {DragMode::Horizontal, Gizmo::Mode::Horizontal}, {DragMode::Vertical, Gizmo::Mode::Vertical},
      {DragMode::AxisX, Gizmo::Mode::AlongX},          {DragMode::AxisY, Gizmo::Mode::AlongY},
      {DragMode::AxisZ, Gizmo::Mode::AlongZ},          {DragMode::OwnAxis, Gizmo::Mode::AlongAxis}};
  for (const auto &[dragMode, gizmoMode] : modes)
    if (dragMode == *mode)
      gizmo.mode = gizmoMode;
  if (*mode == DragMode::Horizontal && handle->motion == Handle::Motion::Coordinate) {
    Formula f;
    const Rational z = handle->at.z - handle->base.z;
    gizmo.note = "z " + f.equals(f(z)) + "\\text{ fixed}";
  }
  return gizmo;
}

SceneContent SceneView::pictureContent() const {
  SceneContent content;
  content.figure = m_model.shownOutcome().figure;
  return content;
}

void SceneView::requestFrame() {
  if (m_awaitingPaint)
    m_frameWanted = true;
  else if (!m_frameTimer.isActive())
    m_frameTimer.start(0);
}

void SceneView::frame() {
  followPointer();
  if (!isValid() || !isVisible())
    return;
  const auto start = Clock::now();
  prepare();
  const auto prepared = Clock::now();
  // Outside of paintGL: VTK then asks for a paint, which only shows what is drawn here.
  m_awaitingPaint = true;
  renderWindow()->SetMultiSamples(m_restTimer.isActive() ? 0 : restSamples);
  renderWindow()->Render();
  emit frameDrawn({m_evaluateTime, prepared - start, Clock::now() - prepared});
  m_evaluateTime = {};
}

void SceneView::paintGL() {
  prepare(); // VTK draws by itself after a change of size
  QVTKOpenGLNativeWidget::paintGL();
  m_awaitingPaint = false;
  if (m_frameWanted) {
    m_frameWanted = false;
    requestFrame();
  }
}

void SceneView::prepare() {
  if (m_contentStale)
    m_scene.setContent(interactiveContent());
  m_contentStale = false;
  m_scene.setView(m_camera, pixelSize(), devicePixelRatioF());
  m_scene.prepare();
}

SceneContent SceneView::interactiveContent() const {
  SceneContent content = pictureContent();
  content.highlighted = m_highlighted;
  if (!m_hoveredMark.empty())
    content.highlighted.insert(m_hoveredMark);
  content.gizmo = gizmo();
  for (const Handle &handle : m_handles)
    if (auto knob = knobOf(handle, handle.id == m_hovered || handle.id == m_selected))
      content.knobs.push_back(std::move(*knob));
  const Handle *dropped = findHandle(m_selected.empty() ? m_hovered : m_selected);
  if (dropped && dropped->motion == Handle::Motion::Coordinate)
    content.dropLine = DropLine{toDouble(dropped->at)};
  return content;
}

void SceneView::startMoving() { m_restTimer.start(); }

// --- pointer
// -------------------------------------------------------------------------------------------------------

bool SceneView::event(QEvent *event) {
  // Axis keys, Escape and arrows belong to the view while it has the focus, before any shortcut of the
  // window.
  if (event->type() == QEvent::ShortcutOverride && m_gesture == Gesture::Handle) {
    event->accept();
    return true;
  }
  return QVTKOpenGLNativeWidget::event(event);
}

void SceneView::mousePressEvent(QMouseEvent *event) {
  if (m_gesture != Gesture::None)
    return;
  m_glide.stop();
  m_pressed = m_lastPointer = event->localPos();
  m_moved = false;
  const glm::dvec2 pixel = devicePixel(m_pressed);
  if (event->button() == Qt::LeftButton) {
    const auto tool = gizmo();
    const auto part =
        tool ? gizmoPartAt(*tool, m_camera, pixelSize(), devicePixelRatioF(), pixel) : std::nullopt;
    const Handle *selected = findHandle(m_selected);
    if (part && selected)
      return pressHandle(*selected, modeOf(*part), pixel);
    if (const Handle *handle = handleAt(pixel)) {
      const bool same = handle->id == m_selected;
      const bool vertical = (same && m_vertical) != bool(event->modifiers() & Qt::ShiftModifier);
      if (const auto mode = grabMode(*handle, vertical, m_camera))
        return pressHandle(*handle, *mode, pixel);
    }
    m_gesture = event->modifiers() & Qt::ShiftModifier ? Gesture::Pan : Gesture::Turn;
  } else {
    m_gesture = Gesture::Pan;
  }
}

void SceneView::mouseDoubleClickEvent(QMouseEvent *event) {
  // Of two quick presses Qt delivers the second only as a double click: to a handle it is a press like any
  // other.
  mousePressEvent(event);
}

void SceneView::pressHandle(const Handle &handle, DragMode mode, glm::dvec2 pixel) {
  m_gesture = Gesture::Handle;
  m_drag.emplace(m_model.session().scene, handle, mode, pixel);
  m_model.beginGesture();
  if (m_selected != handle.id)
    m_vertical = false;
  const bool wasSelected = m_selected == handle.id;
  m_selected = handle.id;
  m_clickToggles = wasSelected;
  setCursor(Qt::ClosedHandCursor);
  updateContent();
  showHint();
}

void SceneView::mouseMoveEvent(QMouseEvent *event) {
  if (m_gesture == Gesture::None)
    return hover(devicePixel(event->localPos()));
  if (event->buttons() == Qt::NoButton) {
    // The release went elsewhere.
    finishDrag();
    return;
  }
  if ((event->localPos() - m_pressed).manhattanLength() > clickSlop)
    m_moved = true;
  if (!m_moved)
    return;
  if (m_gesture == Gesture::Handle) {
    m_pendingPointer = event->localPos();
    startMoving();
    requestFrame();
  } else {
    moveCamera(event->localPos());
  }
}

void SceneView::mouseReleaseEvent(QMouseEvent *) {
  if (m_gesture != Gesture::None)
    finishDrag();
}

void SceneView::followPointer() {
  if (!m_drag || !m_pendingPointer)
    return;
  m_lastPointer = *m_pendingPointer;
  m_pendingPointer.reset();
  const auto start = Clock::now();
  const bool suspended = QGuiApplication::keyboardModifiers() & Qt::AltModifier;
  const auto move =
      m_drag->moveTo(devicePixel(m_lastPointer), suspended ? finestStep : m_model.snapStep(), screen());
  if (!move)
    return;
  m_model.moveGesture({m_drag->handle().object, move->object});
  m_evaluateTime = Clock::now() - start;
  if (move->caught != m_caught) {
    m_caught = move->caught;
    showHint();
  }
  m_contentStale = true;
}

void SceneView::finishDrag() {
  if (m_gesture == Gesture::Handle) {
    followPointer();
    const Handle &handle = m_drag->handle();
    if (m_moved)
      m_model.endGesture(tr("move %1").arg(QString::fromStdString(handle.id)));
    else
      m_model.cancelGesture();
    if (!m_moved && m_clickToggles)
      m_vertical = !m_vertical;
    m_drag.reset();
    m_caught.clear();
  }
  m_gesture = Gesture::None;
  m_pendingPointer.reset();
  unsetCursor();
  updateContent();
  showHint();
}

void SceneView::cancelDrag() {
  m_model.cancelGesture();
  m_drag.reset();
  m_caught.clear();
  m_pendingPointer.reset();
  m_gesture = Gesture::None;
  unsetCursor();
  updateContent();
  showHint();
}

void SceneView::hover(glm::dvec2 pixel) {
  const auto tool = gizmo();
  const auto part =
      tool ? gizmoPartAt(*tool, m_camera, pixelSize(), devicePixelRatioF(), pixel) : std::nullopt;
  const Handle *handle = part ? nullptr : handleAt(pixel);
  const std::string handleId = handle ? handle->id : std::string();
  const std::string mark = handle ? markOf(*handle) : part ? std::string() : m_scene.markAt(pixel);
  if (part == m_hotPart && handleId == m_hovered && mark == m_hoveredMark)
    return;
  m_hotPart = part;
  m_hovered = handleId;
  if (handle || part)
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

// --- camera
// --------------------------------------------------------------------------------------------------------

void SceneView::moveCamera(const QPointF &position) {
  const QPointF moved = position - m_lastPointer;
  m_lastPointer = position;
  m_atHome = false;
  if (m_gesture == Gesture::Turn)
    m_camera.turn(-moved.x() * radiansPerPixel, moved.y() * radiansPerPixel);
  else
    m_camera.pan(glm::dvec2(moved.x(), moved.y()) * devicePixelRatioF(), pixelSize());
  startMoving();
  updateContent();
}

void SceneView::wheelEvent(QWheelEvent *event) {
  m_glide.stop();
  m_atHome = false;
  const double steps = event->angleDelta().y() / 120.0;
  m_camera.zoom(std::pow(zoomPerWheelStep, steps), devicePixel(event->position()), pixelSize());
  startMoving();
  updateContent();
  event->accept();
}

void SceneView::glideTo(const Camera &camera) {
  m_glide.stop();
  m_atHome = false;
  if (!m_motion || !isVisible()) {
    m_camera = camera;
    return updateContent();
  }
  const Camera from = m_camera;
  m_glide.disconnect(this);
  m_glide.setStartValue(0.0);
  m_glide.setEndValue(1.0);
  m_glide.setDuration(glideTime);
  m_glide.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&m_glide, &QVariantAnimation::valueChanged, this, [this, from, camera](const QVariant &value) {
    m_camera = between(from, camera, value.toDouble());
    startMoving();
    updateContent();
  });
  m_glide.start();
}

void SceneView::goHome() {
  Camera camera = homeView(m_model.lesson().camera, m_model.outcome().figure, pixelSize());
  camera.orthographic = m_camera.orthographic;
  glideTo(camera);
  m_atHome = true;
}

void SceneView::resizeEvent(QResizeEvent *event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  // As long as nobody has moved the camera, the figure stays in view at every size.
  if (m_atHome)
    m_camera = homeView(m_model.lesson().camera, m_model.outcome().figure, pixelSize());
  requestFrame();
}

void SceneView::setAxisView(AxisView view) { glideTo(seenAlong(view, m_camera)); }

void SceneView::lookAlongPlane() { glideTo(seenAlongPlane(m_model.outcome().figure, m_camera)); }

void SceneView::lookDownRay() { glideTo(seenDownRay(m_model.session().scene, m_camera)); }

void SceneView::setOrthographic(bool on) {
  m_camera.orthographic = on;
  updateContent();
}

void SceneView::fit() { glideTo(fitted(m_camera, placesOf(m_model.shownOutcome().figure), pixelSize())); }

// --- keys
// ----------------------------------------------------------------------------------------------------------

void SceneView::setDragMode(DragMode mode) {
  if (!m_drag || m_drag->mode() == DragMode::OwnAxis)
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
      selectHandle({});
    return;
  }
  if (event->key() == Qt::Key_Shift && m_drag && m_drag->mode() == DragMode::Horizontal)
    return setDragMode(DragMode::Vertical);
  if (lockAxis(event->key()) || stepSelected(*event))
    return;
  QVTKOpenGLNativeWidget::keyPressEvent(event);
}

void SceneView::keyReleaseEvent(QKeyEvent *event) {
  if (event->key() == Qt::Key_Shift && m_drag && m_drag->mode() == DragMode::Vertical && !m_vertical)
    return setDragMode(DragMode::Horizontal);
  QVTKOpenGLNativeWidget::keyReleaseEvent(event);
}

bool SceneView::stepSelected(const QKeyEvent &event) {
  const Handle *handle = findHandle(m_selected);
  const Object *object = handle ? findObject(m_model.session().scene, handle->object) : nullptr;
  if (!object || m_gesture != Gesture::None)
    return false;
  const auto place = steppedPlace(*handle, event.key(), event.modifiers(), m_model.snapStep(), m_camera);
  if (!place)
    return false;
  m_model.edit({handle->object, movedTo(*object, *handle, *place)},
               tr("move %1").arg(QString::fromStdString(handle->id)));
  return true;
}

void SceneView::showHint() {
  const Handle *handle = findHandle(m_selected);
  if (!m_caught.empty())
    emit hint(QString::fromStdString(m_caught));
  else if (!handle)
    emit hint(tr("Drag a handle to move it, drag beside it to turn the view. The wheel zooms."));
  else if (const auto mode = m_drag ? std::optional(m_drag->mode()) : grabMode(*handle, m_vertical, m_camera))
    emit hint(hintFor(*mode));
  else
    emit hint(tr("Turn the view: from here this handle is seen end-on."));
}

} // namespace halfspace
