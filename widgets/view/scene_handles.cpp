#include "widgets/view/scene_handles.h"

#include "widgets/picture/hand/drop_line.h"
#include "widgets/view/handle_hints.h"
#include "widgets/view/staged_scene.h"

#include <utility>

namespace halfspace {
namespace {

/// Who has dragged so many handles needs no words about it any more.
constexpr int dragsToLearn = 3;

} // namespace

SceneHandles::SceneHandles(SessionModel &model, Viewpoint &viewpoint, const DrawnFigure &drawn,
                           const HandleHold &hold, std::function<std::string(glm::dvec2)> markAt)
    : m_model(model), m_viewpoint(viewpoint), m_drawn(drawn), m_hold(hold), m_markAt(std::move(markAt)),
      m_theme(themes().front()) {}

void SceneHandles::takeHandles() {
  std::vector<Handle> handles = handlesOf(stagedScene(m_model, m_model.stage()));
  if (m_hold.isHolding())
    keepStill(handles, m_selection.handles());
  m_selection.take(std::move(handles));
}

void SceneHandles::takeLesson() {
  select({});
  takeHandles();
}

void SceneHandles::takeOutcome() {
  const std::string selected = m_selection.selectedId();
  const bool inGesture = m_model.history().inGesture();
  if (inGesture)
    takeHandles();
  else
    takeOthers();
  if (!inGesture || m_selection.selectedId() != selected)
    emit selectionChanged();
  emit changed();
  emit hintChanged(); // from its new place a handle may move otherwise
}

void SceneHandles::takeOthers() {
  const std::vector<Handle> before = m_selection.handles();
  takeHandles();
  // The view stays where it is when a position is typed out of it; the hint then tells the way there.
  m_viewpoint.noticeTyped(movedPositions(before, m_selection.handles()));
}

void SceneHandles::settle() {
  takeHandles();
  emit changed();
  emit hintChanged();
}

std::optional<CoordinateId> SceneHandles::selectedCoordinate() const {
  const Handle *handle = m_selection.selected();
  return handle ? std::optional(CoordinateId{handle->object, handle->coordinate}) : std::nullopt;
}

void SceneHandles::select(const std::string &id) {
  m_selection.select(id);
  emit changed();
  emit hintChanged();
  emit selectionChanged();
}

bool SceneHandles::selectNext(bool forward) {
  const std::string next = m_selection.next(forward);
  select(next);
  return !next.empty();
}

std::vector<Grip> SceneHandles::grips() const {
  return gripsOf(m_selection.handles(), m_selection.selectedId(), m_drawn.figure(), m_theme,
                 m_viewpoint.view());
}

Touched SceneHandles::touchedAt(glm::dvec2 pixel) const {
  return halfspace::touchedAt(pixel, m_selection, grips(), gizmo(), m_viewpoint.view());
}

std::string SceneHandles::markOf(const Handle &handle) const {
  if (handle.motion != Handle::Motion::Coordinate)
    return handle.object;
  return fullName(m_model.session().scene, {handle.object, handle.coordinate});
}

std::string SceneHandles::markAt(glm::dvec2 pixel) const {
  const auto [handle, part] = touchedAt(pixel);
  return handle ? markOf(*handle) : part ? markOf(*m_selection.selected()) : m_markAt(pixel);
}

void SceneHandles::hover(glm::dvec2 pixel) {
  const auto [handle, part] = touchedAt(pixel);
  const std::string id = handle ? handle->id : std::string();
  const std::string mark = handle ? markOf(*handle) : part ? std::string() : m_markAt(pixel);
  if (part == m_hotPart && id == m_selection.hoveredId() && mark == m_hoveredMark)
    return;
  m_hotPart = part;
  m_selection.hover(id);
  emit canGrabChanged(handle || part || handleOfBody(mark, m_drawn.figure(), m_selection.handles()));
  if (std::exchange(m_hoveredMark, mark) != mark)
    emit markHovered(QString::fromStdString(mark));
  emit changed();
}

std::optional<SceneHandles::Grab> SceneHandles::grabAt(glm::dvec2 pixel, bool shifted) const {
  auto [handle, part] = touchedAt(pixel);
  if (part)
    return Grab{*m_selection.selected(), modeOf(*part)};
  bool vertical = shifted;
  if (handle && handle->id == m_selection.selectedId())
    vertical = m_selection.isVertical() != shifted;
  else if (!handle)
    handle = handleOfBody(m_markAt(pixel), m_drawn.figure(), m_selection.handles());
  const auto mode = handle ? grabMode(*handle, vertical, m_viewpoint.camera()) : std::nullopt;
  return mode ? std::optional(Grab{*handle, *mode}) : std::nullopt;
}

std::optional<Gizmo> SceneHandles::gizmo() const {
  const Handle *handle = m_selection.selected();
  if (!handle)
    return {};
  const auto mode = m_hold.isHolding() ? m_hold.mode() : m_selection.mode(m_viewpoint.camera());
  Gizmo gizmo = gizmoOf(*handle, mode);
  gizmo.hot = m_hotPart;
  if (gizmo.axes)
    gizmo.clearOf = strokesOf(grips());
  if (mode == DragMode::Horizontal && handle->motion == Handle::Motion::Coordinate)
    gizmo.note = fixedNote(*handle, m_model.session().scene, m_model.evaluation());
  return gizmo;
}

void SceneHandles::addTo(SceneContent &content) const {
  content.gizmo = gizmo();
  content.knobs = knobs();
  const Handle *dropped = m_selection.regarded();
  if (dropped && content.stage.hasGround())
    content.dropLine = dropLineOf(*dropped, m_drawn.areNumbersHidden());
}

QString SceneHandles::hint() const {
  if (!m_hold.caught().empty())
    return QString::fromStdString(m_hold.caught());
  if (m_viewpoint.hasTypedAway())
    return typedAwayHint();
  const Camera &camera = m_viewpoint.camera();
  if (const Handle *handle = m_selection.selected())
    return hintOf(*handle, m_hold.isHolding() ? m_hold.mode() : m_selection.mode(camera), camera);
  if (!m_model.stage().hasAxes())
    return noAxesHint();
  return m_hold.dragCount() < dragsToLearn ? firstHint() : QString();
}

} // namespace halfspace
