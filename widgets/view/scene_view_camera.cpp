// The scene view's camera.
#include "widgets/picture/camera_views.h"
#include "widgets/view/scene_view.h"

#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace halfspace {
namespace {

constexpr int glideTime = 350; // milliseconds
constexpr double radiansPerPixel = 0.005;
constexpr double zoomPerWheelStep = 0.88;

} // namespace

void SceneView::moveCamera(const QPointF &position) {
  const QPointF moved = position - m_lastPointer;
  m_lastPointer = position;
  m_atHome = false;
  if (m_gesture == Gesture::Turn)
    m_camera.turnAbout(m_pivot, -moved.x() * radiansPerPixel, moved.y() * radiansPerPixel);
  else
    m_camera.pan(glm::dvec2(moved.x(), moved.y()) * devicePixelRatioF(), pixelSize());
  keepView(m_camera);
  showMoved();
}

void SceneView::showPreviousView() {
  auto camera = m_previousViews.takeLast();
  if (!camera)
    return;
  camera->orthographic = m_camera.orthographic;
  glideTo(*camera);
}

void SceneView::chooseView(const Camera &camera) {
  if (!(camera == m_camera))
    m_previousViews.remember(m_camera);
  glideTo(camera);
}

void SceneView::wheelEvent(QWheelEvent *event) {
  m_glide.stop();
  m_previousViews.rememberZoomed(m_camera);
  m_atHome = false;
  const double steps = event->angleDelta().y() / 120.0;
  m_camera.zoom(std::pow(zoomPerWheelStep, steps), devicePixel(event->position()), pixelSize());
  keepView(m_camera);
  showMoved();
  event->accept();
}

void SceneView::glideTo(const Camera &camera) {
  m_glide.stop();
  m_atHome = false;
  keepView(camera);
  if (!m_motion || !isVisible()) {
    m_camera = camera;
    showHint();
    return m_frames.request();
  }
  const Camera from = m_camera;
  m_glide.disconnect(this);
  m_glide.setStartValue(0.0);
  m_glide.setEndValue(1.0);
  m_glide.setDuration(glideTime);
  m_glide.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&m_glide, &QVariantAnimation::valueChanged, this, [this, from, camera](const QVariant &value) {
    m_camera = between(from, camera, value.toDouble());
    showMoved();
  });
  m_glide.start();
}

Camera SceneView::fittedTo(Camera from, const Figure &figure, bool axes) const {
  std::vector<Place> places = placesOf(figure);
  for (const Handle &handle : m_handles)
    places.push_back(shownPlace(handle));
  if (axes)
    for (const Place &tip : axisTips(figure))
      places.push_back(tip);
  from.orthographic = m_camera.orthographic;
  return fitted({from, pixelSize(), designRatio(), m_covered}, places);
}

Camera SceneView::fittedToGiven(const Camera &from) const {
  return fittedTo(from, nearGiven(staged(m_model.figure())), m_stage.hasAxes());
}

Camera SceneView::home() const { return fittedToGiven(Camera(m_model.lesson().camera)); }

void SceneView::goHome() {
  chooseView(home());
  m_atHome = true;
  if (!m_camera.orthographic)
    m_model.setView({});
}

void SceneView::keepView(const Camera &camera) {
  m_hasTypedAway = false;
  m_model.setView(ChosenView{{-camera.viewDirection(), camera.target, camera.height}, camera.orthographic});
}

void SceneView::takeView() {
  const std::optional<ChosenView> view = m_model.session().view;
  m_camera.orthographic = view && view->orthographic;
  emit orthographicChanged(m_camera.orthographic);
  if (!view)
    return goHome();
  m_atHome = false;
  m_glide.stop();
  m_camera = Camera(view->view);
  m_camera.orthographic = view->orthographic;
  m_frames.request();
}

void SceneView::showAll() {
  m_glide.stop();
  m_camera = m_atHome ? home() : fittedToGiven(m_camera);
  if (!m_atHome)
    keepView(m_camera);
}

void SceneView::setCovered(const std::vector<QRect> &rectangles) {
  std::vector<PixelBox> covered;
  for (const QRect &rectangle : rectangles)
    covered.push_back(
        {devicePixel(rectangle.topLeft()), devicePixel(rectangle.bottomRight() + QPoint(1, 1))});
  if (covered == m_covered)
    return;
  m_covered = std::move(covered);
  if (m_atHome && !m_model.inGesture())
    showAll();
  m_frames.request();
}

void SceneView::keepInView() {
  const PixelSize before = std::exchange(m_size, pixelSize());
  if (m_atHome && !m_model.inGesture()) // what is held would slip from under the hand
    return showAll();
  if (before == m_size)
    return;
  if (!m_resize || !(m_resize->after == m_camera))
    m_resize = Resize{m_camera, before, m_camera};
  m_camera = keptBetweenSides(m_resize->before, m_resize->size, m_size);
  m_resize->after = m_camera;
}

void SceneView::resizeEvent(QResizeEvent *event) {
  QVTKOpenGLNativeWidget::resizeEvent(event);
  keepInView();
  m_frames.request();
}

void SceneView::setAxisView(AxisView view) { chooseView(fittedToGiven(seenAlong(view, m_camera))); }

void SceneView::lookAlongPlane() {
  chooseView(fittedToGiven(seenAlongPlane(staged(m_model.figure()), m_camera)));
}

void SceneView::facePlane() {
  chooseView(fittedToGiven(seenFacingPlane(staged(m_model.figure()), m_camera)));
}

void SceneView::lookAlongCourse(AlongCourse way) {
  const Camera along = seenAlongCourse(way, staged(m_model.shown().figure), m_camera);
  // The eye looks back from beyond what the course leads to.
  chooseView(way == AlongCourse::Against ? fittedToGiven(along) : along);
}

void SceneView::setOrthographic(bool on) {
  m_glide.stop();
  m_camera.orthographic = on;
  keepView(m_camera);
  m_frames.request();
}

void SceneView::fit() { chooseView(fittedTo(m_camera, staged(m_model.shown().figure), false)); }

void SceneView::showAnother() { m_atHome ? goHome() : chooseView(fittedToGiven(m_camera)); }

} // namespace halfspace
