#include "widgets/view/scene_view.h"

#include "widgets/picture/hand/handle_drag.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace halfspace {

SceneView::SceneView(SessionModel &model, const Typesetter &typesetter, QWidget *parent)
    : QVTKOpenGLNativeWidget(parent), m_model(model), m_viewpoint(model, [this] { return screen(); }),
      m_drawn(model), m_hold(model), m_handles(model, m_viewpoint, m_drawn, m_hold,
                                               [this](glm::dvec2 pixel) { return m_drawing.markAt(pixel); }),
      m_edits(model, m_viewpoint, m_handles), m_input(*this, m_viewpoint, m_handles, m_edits, m_hold),
      m_drawing(*this, typesetter, m_viewpoint, m_drawn, m_handles, m_hold) {
  setAccessibleName(tr("3D scene"));
  followModel();
  joinParts();
  takeOutcome();
}

void SceneView::followModel() {
  connect(&m_model, &SessionModel::lessonChanged, this, &SceneView::takeLesson);
  connect(&m_model, &SessionModel::outcomeChanged, this, &SceneView::takeOutcome);
  connect(&m_model.history(), &SessionHistory::gestureSettled, &m_input, &SceneInput::letGo);
  connect(&m_model.history(), &SessionHistory::gestureChanged, &m_drawn,
          [this] { m_drawn.takeGesture(moves()); });
  connect(&m_model, &SessionModel::sceneReplaced, &m_viewpoint, &Viewpoint::showAnother);
}

void SceneView::joinParts() {
  connect(&m_viewpoint, &Viewpoint::moved, this, &SceneView::showMoving);
  connect(&m_viewpoint, &Viewpoint::changed, this, [this] {
    tellHint(); // from elsewhere a handle may move otherwise
    m_drawing.request();
  });
  connect(&m_viewpoint, &Viewpoint::orthographicChanged, this, &SceneView::orthographicChanged);
  connect(&m_viewpoint, &Viewpoint::previousChanged, this, &SceneView::previousViewsChanged);
  connect(&m_drawn, &DrawnFigure::changed, this, [this] {
    m_drawing.requestNew();
    showMoving();
  });
  connect(&m_hold, &HandleHold::pointed, this, &SceneView::showMoving);
  connect(&m_hold, &HandleHold::modeChanged, this, &SceneView::showNew);
  connect(&m_hold, &HandleHold::caughtChanged, this, &SceneView::tellHint);
  connect(&m_handles, &SceneHandles::changed, &m_drawing, &SceneDrawing::requestNew);
  connect(&m_handles, &SceneHandles::hintChanged, this, &SceneView::tellHint);
  connect(&m_edits, &HandleEdits::refused, this, &SceneView::hint);
  connect(&m_handles, &SceneHandles::selectionChanged, this, &SceneView::selectionChanged);
  connect(&m_handles, &SceneHandles::markHovered, this, &SceneView::markHovered);
  connect(&m_input, &SceneInput::dismissed, this, &SceneView::dismissed);
  connect(&m_drawing, &SceneDrawing::noticeChanged, this, &SceneView::noticeChanged);
  connect(&m_drawing, &SceneDrawing::frameDrawn, this, &SceneView::frameDrawn);
}

QSurfaceFormat SceneView::surfaceFormat() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0); // VTK smooths by itself
  return format;
}

void SceneView::setTheme(const Theme &theme) {
  m_handles.setTheme(theme);
  m_drawing.setTheme(theme);
}

void SceneView::setMotion(bool on) {
  m_motion = on;
  if (!on) {
    m_drawn.arrive();
    m_viewpoint.arrive();
  }
  m_drawing.requestNew();
}

void SceneView::setSizeScale(double scale) {
  m_sizeScale = scale;
  m_viewpoint.takeScreen();
}

void SceneView::setHighlighted(std::set<std::string> markIds) {
  m_drawn.setHighlighted(std::move(markIds));
  m_drawing.requestNew();
}

void SceneView::setNumbersHidden(bool hidden) {
  if (m_drawn.setNumbersHidden(hidden))
    m_drawing.requestNew();
}

void SceneView::setCovered(const std::vector<QRect> &rectangles) {
  const auto corner = [this](const QPoint &place) {
    return glm::dvec2(place.x(), place.y()) * devicePixelRatioF();
  };
  std::vector<PixelBox> covered;
  for (const QRect &rectangle : rectangles)
    covered.push_back({corner(rectangle.topLeft()), corner(rectangle.bottomRight() + QPoint(1, 1))});
  m_viewpoint.setCovered(std::move(covered));
}

void SceneView::setAxisView(AxisView view) {
  m_viewpoint.show(view == AxisView::Front   ? NamedView::Front
                   : view == AxisView::Right ? NamedView::Right
                                             : NamedView::Top);
}

void SceneView::lookAlongCourse(AlongCourse way) {
  m_viewpoint.show(way == AlongCourse::Down ? NamedView::DownCourse : NamedView::AgainstCourse);
}

Screen SceneView::screen() const { return {pixelSize(), designRatio(), moves()}; }

PixelSize SceneView::pixelSize() const {
  const double ratio = devicePixelRatioF();
  return {std::max(1, static_cast<int>(std::lround(width() * ratio))),
          std::max(1, static_cast<int>(std::lround(height() * ratio)))};
}

std::string SceneView::toolNote() const {
  const auto tool = m_handles.gizmo();
  return tool ? tool->note : std::string();
}

std::optional<QPoint> SceneView::handlePosition(const std::string &handleId) const {
  const Handle *handle = m_handles.selection().find(handleId);
  if (!handle)
    return {};
  const auto projected = camera().project(shownPlace(*handle), pixelSize());
  if (!projected)
    return {};
  const double ratio = devicePixelRatioF();
  const QPoint position(static_cast<int>(std::lround(projected->x / ratio)),
                        static_cast<int>(std::lround(projected->y / ratio)));
  return rect().contains(position) ? std::optional(position) : std::nullopt;
}

void SceneView::takeLesson() {
  m_handles.takeLesson();
  m_drawn.takeLesson();
  m_viewpoint.takeLesson();
}

void SceneView::takeOutcome() {
  m_viewpoint.takeStage();
  m_drawn.takeOutcome(moves());
  m_handles.takeOutcome();
  m_drawing.takeOutcome(m_model.history().inGesture());
}

void SceneView::showNew() {
  m_drawing.requestNew();
  tellHint();
}

void SceneView::showMoving() {
  tellHint(); // from elsewhere a handle may move otherwise
  m_drawing.requestMoving();
}

void SceneView::paintGL() {
  m_drawing.prepare(); // VTK draws by itself after a change of size
  QVTKOpenGLNativeWidget::paintGL();
  m_drawing.painted();
}

void SceneView::resizeEvent(QResizeEvent *event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  m_viewpoint.takeScreen();
}

bool SceneView::focusNextPrevChild(bool next) {
  // Tab goes from handle to handle; behind the last one it leaves the view.
  return m_handles.selectNext(next) || QVTKOpenGLNativeWidget::focusNextPrevChild(next);
}

} // namespace halfspace
