#include "widgets/view/scene_view.h"

#include <utility>

namespace halfspace {

SceneView::SceneView(SessionModel &model, const Typesetter &typesetter, QWidget *parent)
    : QVTKOpenGLNativeWidget(parent), m_model(model), m_screen(*this),
      m_viewpoint(model, [this] { return m_screen.now(); }), m_drawn(model), m_hold(model),
      m_handles(model, m_viewpoint, m_drawn, m_hold,
                [this](glm::dvec2 pixel) { return m_drawing.markAt(pixel); }),
      m_edits(model, m_viewpoint, m_handles),
      m_input(*this, m_screen, m_viewpoint, m_handles, m_edits, m_hold),
      m_objectHand(*this, m_screen, m_viewpoint, m_model, m_drawn, m_input),
      m_drawing(*this, typesetter, m_viewpoint, m_drawn, m_handles, m_hold) {
  setAccessibleName(tr("3D scene"));
  followModel();
  joinParts();
  takeLesson();
  takeOutcome();
}

void SceneView::followModel() {
  connect(&m_model, &SessionModel::lessonChanged, this, &SceneView::takeLesson);
  connect(&m_model, &SessionModel::outcomeChanged, this, &SceneView::takeOutcome);
  connect(&m_model.history(), &SessionHistory::gestureSettled, &m_input, &SceneInput::letGo);
  connect(&m_model.history(), &SessionHistory::gestureChanged, &m_drawn,
          [this] { m_drawn.takeGesture(m_screen.moves()); });
  connect(&m_model, &SessionModel::sceneReplaced, &m_viewpoint, &Viewpoint::showAnother);
}

void SceneView::joinParts() {
  // From elsewhere a handle may move otherwise.
  connect(&m_viewpoint, &Viewpoint::moved, this, &SceneView::tellHint);
  connect(&m_viewpoint, &Viewpoint::moved, &m_drawing, &SceneDrawing::requestMoving);
  connect(&m_viewpoint, &Viewpoint::changed, this, &SceneView::tellHint);
  connect(&m_viewpoint, &Viewpoint::changed, &m_drawing, &SceneDrawing::request);
  connect(&m_drawn, &DrawnFigure::changed, &m_drawing, &SceneDrawing::requestNew);
  connect(&m_drawn, &DrawnFigure::moved, &m_drawing, &SceneDrawing::requestNewMoving);
  connect(&m_hold, &HandleHold::pointed, &m_drawing, &SceneDrawing::requestMoving);
  connect(&m_hold, &HandleHold::modeChanged, this, &SceneView::tellHint);
  connect(&m_hold, &HandleHold::modeChanged, &m_drawing, &SceneDrawing::requestNew);
  connect(&m_hold, &HandleHold::caughtChanged, this, &SceneView::tellHint); // it may be another at one place
  connect(&m_handles, &SceneHandles::changed, &m_drawing, &SceneDrawing::requestNew);
  connect(&m_handles, &SceneHandles::hintChanged, this, &SceneView::tellHint);
  connect(&m_edits, &HandleEdits::refused, this, &SceneView::hint);
  connect(&m_objectHand, &ObjectHand::promptChanged, this, &SceneView::tellHint);
  connect(&m_objectHand, &ObjectHand::refused, this, &SceneView::hint);
  connect(&m_objectHand, &ObjectHand::markHovered, &m_handles, &SceneHandles::markHovered);
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
  m_screen.setMotion(on);
  if (!on) {
    m_drawn.arrive();
    m_viewpoint.arrive();
  }
  m_drawing.requestNew();
}

void SceneView::setSizeScale(double scale) {
  m_screen.setSizeScale(scale);
  m_viewpoint.takeScreen();
}

void SceneView::setCovered(const std::vector<QRect> &rectangles) {
  std::vector<PixelBox> covered;
  covered.reserve(rectangles.size());
  for (const QRect &rectangle : rectangles)
    covered.push_back(m_screen.boxOf(rectangle));
  m_viewpoint.setCovered(std::move(covered));
}

void SceneView::takeLesson() {
  m_handles.takeLesson();
  m_drawn.takeLesson();
  m_viewpoint.takeLesson();
}

void SceneView::takeOutcome() {
  m_viewpoint.takeStage();
  m_drawn.takeOutcome(m_screen.moves());
  m_handles.takeOutcome();
  m_objectHand.takeOutcome();
  m_drawing.takeOutcome(m_model.history().inGesture());
}

void SceneView::paintGL() {
  m_drawing.prepare();
  QVTKOpenGLNativeWidget::paintGL();
  m_drawing.painted();
}

void SceneView::resizeEvent(QResizeEvent *event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  m_viewpoint.takeScreen();
}

bool SceneView::focusNextPrevChild(bool next) {
  // Tab goes from handle to handle, while the hand is empty; behind the last one it leaves the view.
  return (!m_objectHand.tool() && m_handles.selectNext(next)) ||
         QVTKOpenGLNativeWidget::focusNextPrevChild(next);
}

} // namespace halfspace
