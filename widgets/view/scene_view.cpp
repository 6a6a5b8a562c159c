#include "widgets/view/scene_view.h"

#include "geometry/decide.h"
#include "lessons/term/latex.h"
#include "widgets/picture/hand/drop_line.h"
#include "widgets/picture/shapes/gizmo_shape.h"
#include "widgets/picture/shapes/surface_layers.h"
#include "widgets/scene/render_window.h"
#include "widgets/typeset/label_painter.h"
#include "widgets/typeset/typesetter.h"

#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace halfspace {
namespace {

using Clock = std::chrono::steady_clock;

/// What moves is drawn without smoothing until it has rested for so long, in milliseconds.
constexpr int restDelay = 160;
/// Samples a pixel at rest; while something moves there is one.
constexpr int restSamples = 4;

} // namespace

SceneView::SceneView(SessionModel &model, const Typesetter &typesetter, QWidget *parent)
    : QVTKOpenGLNativeWidget(parent), m_model(model), m_composer(labelSetter(typesetter.fonts())),
      m_scene(labelPainter(typesetter)), m_theme(themes().front()), m_camera(model.lesson().camera) {
  vtkNew<halfspace::RenderWindow> window;
  setRenderWindow(window);
  window->AddRenderer(m_scene.renderer());
  // VTK's own interaction would fight with ours.
  window->GetInteractor()->SetInteractorStyle(nullptr);

  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("3D scene"));
  m_restTimer.setSingleShot(true);
  m_restTimer.setInterval(restDelay);
  connect(&m_frames, &FramePacer::due, this, &SceneView::frame);
  connect(&m_restTimer, &QTimer::timeout, &m_frames, &FramePacer::request);
  connect(&m_fade, &MarkFade::changed, this, [this] {
    m_contentStale = true;
    showMoved();
  });
  connect(&m_model, &SessionModel::lessonChanged, this, [this] {
    selectHandle({});
    m_figure = {};             // nothing of it glides into the next
    m_stage = m_model.stage(); // what the view is fitted to is the new lesson's already
    m_handles = handlesOf(stagedScene());
    takeView();
    m_previousViews.forget();
  });
  connect(&m_previousViews, &PreviousViews::changed, this, &SceneView::previousViewsChanged);
  connect(&m_model, &SessionModel::outcomeChanged, this, &SceneView::takeOutcome);
  connect(&m_extents, &ExtentGlide::changed, this, [this] {
    m_contentStale = true;
    showMoved();
  });
  connect(&m_model, &SessionModel::gestureSettled, this, &SceneView::letGo);
  connect(&m_model, &SessionModel::gestureChanged, this, [this] {
    if (!m_model.inGesture())
      m_extents.release(m_motion && isVisible());
  });
  connect(&m_model, &SessionModel::sceneReplaced, this, &SceneView::showAnother);
  takeOutcome();
}

QSurfaceFormat SceneView::surfaceFormat() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0); // VTK smooths by itself
  return format;
}

SceneView::~SceneView() {
  makeCurrent();
  renderWindow()->RemoveRenderer(m_scene.renderer());
  doneCurrent();
}

void SceneView::setTheme(const Theme &theme) {
  m_theme = theme;
  m_composer.setTheme(theme);
  m_frames.request();
}

void SceneView::setMotion(bool on) {
  m_motion = on;
  if (!on) {
    m_fade.finish();
    m_extents.arrive();
    if (m_glide.state() == QAbstractAnimation::Running)
      m_glide.setCurrentTime(m_glide.duration()); // it arrives
  }
  updateContent();
}

void SceneView::setSizeScale(double scale) {
  m_sizeScale = scale;
  keepInView();
  m_frames.request();
}

void SceneView::setHighlighted(std::set<std::string> markIds) {
  m_highlighted = std::move(markIds);
  updateContent();
}

void SceneView::setNumbersHidden(bool hidden) {
  if (hidden == m_numbersHidden)
    return;
  m_numbersHidden = hidden;
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

View SceneView::screen() const { return {m_camera, pixelSize(), designRatio(), m_covered}; }

const Handle *SceneView::findHandle(const std::string &id) const {
  const auto found =
      std::find_if(m_handles.begin(), m_handles.end(), [&](const Handle &h) { return h.id == id; });
  return found == m_handles.end() ? nullptr : &*found;
}

std::vector<Grip> SceneView::grips() const {
  return gripsOf(m_handles, m_selected, m_figure, m_theme, screen());
}

const Handle *SceneView::handleAt(glm::dvec2 pixel, double margin) const {
  return findHandle(handleGrabbedAt(pixel, grips(), margin * designRatio()));
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
  return fullName(m_model.session().scene, {handle.object, handle.coordinate});
}

void SceneView::selectHandle(const std::string &handleId) {
  if (m_selected != handleId)
    m_vertical = false;
  m_selected = handleId;
  updateContent();
  showHint();
  emit selectionChanged();
}

std::optional<CoordinateId> SceneView::selectedCoordinate() const {
  const Handle *handle = findHandle(m_selected);
  return handle ? std::optional(CoordinateId{handle->object, handle->coordinate}) : std::nullopt;
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

/// Looks at the same part of the scene on another stage.
void SceneView::takeStage() {
  const Stage &stage = m_model.stage();
  if (stage == m_stage)
    return;
  if (m_glide.state() == QAbstractAnimation::Running)
    m_glide.setCurrentTime(m_glide.duration()); // it arrives, in the units that it began with
  const ExactVec3 target = fromStage(exactly(m_camera.target), CoordinateRole::Position, m_stage);
  m_camera.target = glm::clamp(toDouble(toStage(target, CoordinateRole::Position, stage)),
                               -Camera::farthestTarget, Camera::farthestTarget);
  m_camera.height = std::clamp(m_camera.height * toDouble(powerOfTen(m_stage.exponent - stage.exponent)),
                               Camera::minHeight, Camera::maxHeight);
  m_stage = stage;
  m_previousViews.forget();
  m_extents.release(false); // they are in units of the stage before
  showAll();
  showHint();
}

bool SceneView::isInView(const Handle &handle) const {
  const PixelSize size = pixelSize();
  const auto pixel = m_camera.project(toDouble(handle.at), size);
  return pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= size.width && pixel->y <= size.height;
}

/// The view stays where it is when a position is typed out of it; the hint then tells the way there.
void SceneView::noticeTyped(const std::vector<Handle> &before) {
  if (m_model.inGesture())
    return;
  std::unordered_map<std::string_view, const Handle *> old;
  for (const Handle &handle : before)
    old.emplace(handle.id, &handle);
  std::vector<const Handle *> moved;
  for (const Handle &handle : m_handles) {
    const auto known = old.find(handle.id);
    const bool isPosition = handle.motion == Handle::Motion::OnHost ||
                            (handle.motion == Handle::Motion::Coordinate && isZero(handle.base));
    if (isPosition && known != old.end() && !(known->second->at == handle.at))
      moved.push_back(&handle);
  }
  if (!moved.empty())
    m_hasTypedAway =
        std::any_of(moved.begin(), moved.end(), [this](const Handle *handle) { return !isInView(*handle); });
}

void SceneView::holdExtents() {
  const Scene &scene = m_model.session().scene;
  if (!m_extents.isHolding()) {
    Extents extents = extentsOf(m_extents.drawn(m_figure));
    std::erase_if(extents, [&](const auto &held) { return !findObject(scene, held.first); });
    m_extents.hold(std::move(extents));
  }
  for (const std::string &moved : m_model.history().movedByGesture())
    m_extents.leave(moved);
}

void SceneView::glideFrom(Extents before) {
  if (m_model.inGesture() || before == extentsOf(m_figure))
    return;
  m_extents.hold(std::move(before));
  m_extents.release(m_motion && isVisible());
}

void SceneView::takeOutcome() {
  takeStage();
  Extents extents = extentsOf(drawnFigure());
  if (m_model.inGesture()) {
    holdExtents();
    m_restTimer.start(); // what a flight, or a number that is scrubbed, moves comes to rest later as well
  }
  m_figure = staged(m_model.shown().figure);
  const std::vector<Handle> before = std::exchange(m_handles, handlesOf(stagedScene()));
  if (m_drag)
    keepStill(m_handles, before);
  glideFrom(std::move(extents));
  noticeTyped(before);
  if (!findHandle(m_selected))
    m_selected.clear();
  emit selectionChanged();
  if (!findHandle(m_hovered))
    m_hovered.clear();
  m_fade.show(m_model.session(), m_model.shown().figure, m_motion && isVisible());
  updateContent();
  showHint(); // from its new place a handle may move otherwise
  m_outcomeTaken = Clock::now();
}

void SceneView::updateContent() {
  m_contentStale = true;
  m_frames.request();
}

void SceneView::showMoved() {
  showHint(); // from elsewhere a handle may move otherwise
  m_restTimer.start();
  m_frames.request();
}

std::optional<Gizmo> SceneView::gizmo() const {
  const Handle *handle = findHandle(m_selected);
  if (!handle)
    return {};
  Gizmo gizmo;
  gizmo.at = shownPlace(*handle);
  gizmo.hot = m_hotPart;
  const auto mode = m_drag ? std::optional(m_drag->mode()) : grabMode(*handle, m_vertical, m_camera);
  gizmo.axes = mode && !isOwn(*mode);
  if (gizmo.axes)
    gizmo.clearOf = strokesOf(grips());
  if (!mode)
    return gizmo;
  if (handle->hasAxis())
    gizmo.axis = toDouble(handle->axis);
  gizmo.normal = handle->center ? toDouble(handle->at - *handle->center) : toDouble(handle->normal);
  static const std::pair<DragMode, Gizmo::Mode> modes[] = {
      {DragMode::Horizontal, Gizmo::Mode::Horizontal}, {DragMode::Vertical, Gizmo::Mode::Vertical},
      {DragMode::AxisX, Gizmo::Mode::AlongX},          {DragMode::AxisY, Gizmo::Mode::AlongY},
      {DragMode::AxisZ, Gizmo::Mode::AlongZ},          {DragMode::OwnAxis, Gizmo::Mode::AlongAxis},
      {DragMode::OwnPlane, Gizmo::Mode::InPlane},      {DragMode::OwnSphere, Gizmo::Mode::InPlane}};
  for (const auto &[dragMode, gizmoMode] : modes)
    if (dragMode == *mode)
      gizmo.mode = gizmoMode;
  if (*mode == DragMode::Horizontal && handle->motion == Handle::Motion::Coordinate)
    gizmo.note = fixedNote(*handle);
  return gizmo;
}

std::string SceneView::fixedNote(const Handle &handle) const {
  const Object &object = *findObject(m_model.session().scene, handle.object);
  Symbol symbol = letter("z");
  // Of an arrow's tip it is the arrow's own number, as it stands in the formulas, and not the tip's height.
  if (coordinatesOf(object)[handle.coordinate].role == CoordinateRole::Direction) {
    symbol = m_model.evaluation().find(handle.object)->own->letters[handle.coordinate];
    symbol.isVector = false;
    symbol.subscript += symbol.subscript.empty() ? "z" : ",z";
  }
  return latexOf(symbol) + relatedLatex(Term(object[handle.coordinate].z)) + "\\text{ fixed}";
}

std::vector<Knob> SceneView::knobs() const {
  std::vector<Knob> knobs;
  for (const Handle &handle : m_handles)
    if (auto knob = knobOf(handle, handle.id == m_hovered || handle.id == m_selected);
        knob && grabMode(handle, m_vertical, m_camera))
      knobs.push_back(std::move(*knob));
  return knobs;
}

SceneContent SceneView::pictureContent() const {
  SceneContent content;
  content.stage = m_stage;
  content.figure = m_figure;
  content.hasShadows = m_model.lesson().hasShadows;
  if (m_numbersHidden)
    content.figure = withoutNumbers(std::move(content.figure));
  return content;
}

void SceneView::frame() {
  m_frames.begin();
  followPointer();
  if (!isValid() || !isVisible())
    return;
  const auto start = Clock::now();
  prepare();
  const auto prepared = Clock::now();
  // Outside of paintGL: VTK then asks for a paint, which only shows what is drawn here.
  m_frames.awaitPaint();
  renderWindow()->SetMultiSamples(m_restTimer.isActive() ? 0 : restSamples);
  renderWindow()->Render();
  m_times.update = prepared - start;
  m_times.render = Clock::now() - prepared;
  emit frameDrawn(std::exchange(m_times, {}));
}

void SceneView::paintGL() {
  prepare(); // VTK draws by itself after a change of size
  QVTKOpenGLNativeWidget::paintGL();
  m_frames.painted();
}

void SceneView::prepare() {
  if (m_contentStale)
    m_composer.setContent(interactiveContent());
  else
    m_composer.setTools(gizmo(), knobs()); // how a handle can be moved depends on the camera
  m_contentStale = false;
  m_composer.setView(screen());
  const ShapeList &shapes = m_composer.compose();
  m_scene.show(shapes);
  tellNotice(shapes.leavesOutSurfaces);
}

void SceneView::tellNotice(bool leavesOutSurfaces) {
  const QString notice = leavesOutSurfaces ? QString::fromStdString(overfullWords()) : QString();
  if (std::exchange(m_notice, notice) != notice)
    emit noticeChanged(notice);
}

SceneContent SceneView::interactiveContent() const {
  SceneContent content = pictureContent();
  content.figure = m_extents.drawn(std::move(content.figure)); // whether with its numbers or without
  content.highlighted = m_highlighted;
  content.arrival = m_fade.arrival();
  if (!m_hoveredMark.empty())
    content.highlighted.insert(m_hoveredMark);
  content.gizmo = gizmo();
  content.knobs = knobs();
  const Handle *dropped = findHandle(m_selected.empty() ? m_hovered : m_selected);
  if (dropped && m_stage.hasGround())
    content.dropLine = dropLineOf(*dropped, m_numbersHidden);
  return content;
}

} // namespace halfspace
