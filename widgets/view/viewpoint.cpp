#include "widgets/view/viewpoint.h"

#include "geometry/decide.h"
#include "widgets/picture/hand/handle_drag.h"
#include "widgets/view/staged_scene.h"

#include <glm/common.hpp>

#include <algorithm>
#include <utility>

namespace halfspace {

Viewpoint::Viewpoint(SessionModel &model, std::function<Screen()> screen)
    : m_model(model), m_screen(std::move(screen)), m_camera(model.lesson().camera) {
  connect(&m_glide, &CameraGlide::moved, this, [this](const Camera &camera) {
    m_camera = camera;
    emit moved();
  });
}

View Viewpoint::view() const {
  const Screen screen = m_screen();
  return {m_camera, screen.size, screen.pixelRatio, m_covered};
}

Place Viewpoint::middle() const { return middleInView(view(), placesOf(sight())); }

Sight Viewpoint::sight() const {
  Sight sight{toStage(m_model.figure(), m_stage), toStage(m_model.shown().figure, m_stage)};
  for (const Handle &handle : handlesOf(stagedScene(m_model, m_stage)))
    sight.handles.push_back(shownPlace(handle));
  sight.start = m_model.lesson().camera;
  sight.hasAxes = m_stage.hasAxes();
  return sight;
}

void Viewpoint::show(NamedView name) {
  choose(seenAs(name, sight(), view()));
  if (name != NamedView::Home)
    return;
  m_isAtHome = true;
  if (!m_camera.orthographic)
    m_model.history().setView({});
}

void Viewpoint::showAnother() { show(m_isAtHome ? NamedView::Home : NamedView::Whole); }

void Viewpoint::setOrthographic(bool on) {
  stop();
  m_camera.orthographic = on;
  keep(m_camera);
  emit changed();
}

void Viewpoint::showPrevious() {
  auto camera = m_previous.takeLast();
  if (!camera)
    return;
  camera->orthographic = m_camera.orthographic;
  glideTo(*camera);
}

void Viewpoint::choose(const Camera &camera) {
  if (!(camera == m_camera))
    m_previous.remember(m_camera);
  glideTo(camera);
}

void Viewpoint::glideTo(const Camera &camera) {
  stop();
  m_isAtHome = false;
  keep(camera);
  if (m_screen().moves)
    return m_glide.start(m_camera, camera);
  m_camera = camera;
  emit changed();
}

void Viewpoint::moveTo(const Camera &camera) {
  m_isAtHome = false;
  m_camera = camera;
  keep(camera);
  emit moved();
}

void Viewpoint::keep(const Camera &camera) {
  m_hasTypedAway = false;
  m_model.history().setView(chosenViewOf(camera));
}

void Viewpoint::showAll() {
  stop();
  m_camera = seenAs(m_isAtHome ? NamedView::Home : NamedView::Whole, sight(), view());
  if (!m_isAtHome)
    keep(m_camera);
}

void Viewpoint::setCovered(std::vector<PixelBox> covered) {
  if (covered == m_covered)
    return;
  m_covered = std::move(covered);
  if (m_isAtHome && !m_model.history().inGesture())
    showAll();
  emit changed();
}

void Viewpoint::takeScreen() {
  const PixelSize size = m_screen().size;
  if (m_isAtHome && !m_model.history().inGesture()) { // what is held would slip from under the hand
    m_resized.setSize(size);
    showAll();
  } else {
    m_camera = m_resized.resized(m_camera, size);
  }
  emit changed();
}

void Viewpoint::takeLesson() {
  m_stage = m_model.stage();
  const std::optional<ChosenView> chosen = m_model.session().view;
  m_camera.orthographic = chosen && chosen->orthographic;
  emit orthographicChanged(m_camera.orthographic);
  if (chosen) {
    stop();
    m_isAtHome = false;
    m_camera = cameraOf(*chosen);
    emit changed();
  } else {
    show(NamedView::Home);
  }
  m_previous.forget();
}

void Viewpoint::takeStage() {
  const Stage &stage = m_model.stage();
  if (stage == m_stage)
    return;
  arrive(); // in the units that the way began with
  const ExactVec3 target = fromStage(exactly(m_camera.target), CoordinateRole::Position, m_stage);
  m_camera.target = glm::clamp(toDouble(toStage(target, CoordinateRole::Position, stage)),
                               -Camera::farthestTarget, Camera::farthestTarget);
  m_camera.height = std::clamp(m_camera.height * toDouble(powerOfTen(m_stage.exponent - stage.exponent)),
                               Camera::minHeight, Camera::maxHeight);
  m_stage = stage;
  m_previous.forget();
  showAll();
  emit changed();
}

void Viewpoint::takeGrown() {
  if (!m_isAtHome || m_model.history().inGesture() || areInView(placesOf(sight())))
    return; // who clicks several places finds them where they were
  showAll();
  emit changed();
}

void Viewpoint::noticeTyped(const std::vector<Place> &places) {
  if (!places.empty())
    m_hasTypedAway = !areInView(places);
}

bool Viewpoint::areInView(const std::vector<Place> &places) const {
  const PixelSize size = m_screen().size;
  return std::all_of(places.begin(), places.end(), [&](const Place &place) {
    const auto pixel = m_camera.project(place, size);
    return pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= size.width && pixel->y <= size.height;
  });
}

} // namespace halfspace
