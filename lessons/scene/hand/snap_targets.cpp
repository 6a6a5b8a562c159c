#include "lessons/scene/hand/snap_targets.h"

#include "lessons/object/kind.h"
#include "lessons/scene/edit.h"
#include "lessons/scene/scene_letters.h"

#include <string_view>
#include <unordered_set>

namespace halfspace {
namespace {

/// What the objects offer that do not move with the handled one.
Surroundings surroundingsOf(const PlacedScene &placed, const SceneLetters &letters,
                            const std::string &handled) {
  Surroundings found;
  found.origin = placed.origin;
  for (const Entry &entry : placed.scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content); object && entry.name != handled)
      object->kind().offer(letters.given(entry.name, *object), found);
  const std::vector<std::string> dependents = dependentsOf(placed.scene, handled);
  const std::unordered_set<std::string_view> moving{dependents.begin(), dependents.end()};
  for (const PlacedObject &bound : placed.bound)
    if (bound.name != handled && !moving.contains(bound.name))
      bound.point->object.kind().offer(*bound.point, found);
  return found;
}

} // namespace

std::vector<SnapTarget> snapTargets(const PlacedScene &placed, const Handle &handle) {
  const Object *object = findObject(placed.scene, handle.object);
  std::vector<SnapTarget> targets;
  if (!object || handle.motion == Handle::Motion::Whole)
    return targets;
  const SceneLetters letters(placed.scene);
  const Surroundings found = surroundingsOf(placed, letters, handle.object);
  const bool isPosition = handle.motion == Handle::Motion::OnHost ||
                          (handle.motion == Handle::Motion::Coordinate &&
                           coordinatesOf(*object)[handle.coordinate].role == CoordinateRole::Position);
  if (isPosition)
    aimAtPlaces(found, targets);
  object->kind().aim(letters.given(handle.object, *object), handle, found, targets);
  return targets;
}

} // namespace halfspace
