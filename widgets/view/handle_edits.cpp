#include "widgets/view/handle_edits.h"

#include "lessons/object/corners.h"
#include "lessons/scene/change_words.h"
#include "widgets/view/handle_hints.h"
#include "widgets/view/key_steps.h"
#include "widgets/view/staged_scene.h"

#include <algorithm>

namespace halfspace {
namespace {

int cornerCount(const Object &object) { return static_cast<int>(cornersOf(object).size()); }

} // namespace

bool HandleEdits::change(const std::string &object, const Object &changed, const QString &description) {
  const QString refusal = m_model.history().edit(ChangeObject{object, changed}, description);
  if (!refusal.isEmpty())
    emit refused(refusal);
  return refusal.isEmpty();
}

bool HandleEdits::step(int key, Qt::KeyboardModifiers modifiers) {
  const HandleSelection &selection = m_handles.selection();
  const Handle *handle = selection.selected();
  const auto place = handle ? steppedPlace(*handle, selection.isVertical() ? verticalKey(key) : key,
                                           modifiers, m_model.snapping().step, m_viewpoint.camera())
                            : std::nullopt;
  if (!place)
    return false;
  const Scene scene = stagedScene(m_model, m_model.stage()).scene;
  const Object &object = *findObject(scene, handle->object);
  // On a plane or a ball the place is brought back to it; with half the step as a grid no press is lost.
  const ExactVec3 way = *place - handle->at;
  const Rational halfStep = (abs(way.x) + abs(way.y) + abs(way.z)) / 2;
  const bool isOnSurface = handle->host && !handle->hasAxis();
  const Object moved =
      isOnSurface ? movedToGrid(object, *handle, *place, halfStep) : movedTo(object, *handle, *place);
  change(handle->object, fromStage(moved, m_model.stage()),
         QString::fromStdString(wordsForMoving(m_model.session().scene, *handle)));
  return true;
}

const Object *HandleEdits::objectOfSelected() const {
  const Handle *handle = m_handles.selection().selected();
  return handle && handle->motion == Handle::Motion::Coordinate
             ? findObject(m_model.session().scene, handle->object)
             : nullptr;
}

bool HandleEdits::isCornerSelected() const {
  const Object *object = objectOfSelected();
  const auto corners = object ? cornersOf(*object) : std::vector<std::size_t>();
  return object &&
         std::binary_search(corners.begin(), corners.end(), m_handles.selection().selected()->coordinate);
}

void HandleEdits::addCorner() {
  if (!isCornerSelected())
    return;
  const Handle corner = *m_handles.selection().selected(); // the handles are made anew by the edit
  const Object &object = *objectOfSelected();
  if (!canAddCornerAfter(object, corner.coordinate)) {
    emit refused(mostCornersHint(cornerCount(object)));
    return;
  }
  const Object more = withCornerAfter(object, corner.coordinate);
  if (!change(corner.object, more, tr("Add a corner")))
    return;
  const auto corners = cornersOf(more);
  const std::size_t added = *std::upper_bound(corners.begin(), corners.end(), corner.coordinate);
  m_handles.select(coordinateId(corner.object, coordinatesOf(more)[added]));
}

void HandleEdits::removeCorner() {
  if (!isCornerSelected())
    return;
  const Handle corner = *m_handles.selection().selected();
  const Object &object = *objectOfSelected();
  if (canRemoveCorner(object, corner.coordinate))
    change(corner.object, withoutCorner(object, corner.coordinate), tr("Remove a corner"));
  else
    emit refused(fewestCornersHint(cornerCount(object)));
}

} // namespace halfspace
