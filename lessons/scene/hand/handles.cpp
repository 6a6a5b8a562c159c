#include "lessons/scene/hand/handles.h"

#include "lessons/object/bound_point.h"

#include <algorithm>

namespace halfspace {
namespace {

/// A position is grabbed where it is, a direction at its tip.
void addCoordinateHandles(const std::string &name, const Object &object, std::vector<Handle> &handles) {
  const auto specs = coordinatesOf(object);
  for (std::size_t index = 0; index < specs.size(); ++index) {
    if (numbersIn(specs[index].role) == 1)
      continue;
    Handle handle;
    handle.id = coordinateId(name, specs[index]);
    handle.object = name;
    handle.coordinate = index;
    if (specs[index].role == CoordinateRole::Direction)
      handle.base = object[0];
    handle.at = handle.base + object[index];
    handles.push_back(std::move(handle));
  }
}

/// What nobody sees cannot be taken either.
bool canBeHeld(const Entry &entry) { return !entry.isLocked && !entry.isHidden; }

} // namespace

std::vector<Handle> handlesOf(const PlacedScene &placed) {
  std::vector<Handle> handles;
  for (const Entry &entry : placed.scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content);
        object && !isBound(entry) && canBeHeld(entry)) {
      addCoordinateHandles(entry.name, *object, handles);
      for (Handle &own : object->kind().ownHandles(entry.name, *object))
        handles.push_back(std::move(own));
    }
  // Last, so that where a bound point lies on a handle of its host it is the one to be grabbed.
  for (const PlacedObject &bound : placed.bound)
    if (canBeHeld(*placed.scene.entries.find(bound.name)))
      handles.push_back(boundHandle(bound.name, *findObject(placed.scene, bound.name), bound.host->object,
                                    bound.point->object[0]));
  return handles;
}

void keepStill(std::vector<Handle> &handles, const std::vector<Handle> &before) {
  for (Handle &handle : handles) {
    if (handle.motion != Handle::Motion::Whole)
      continue;
    const auto old = std::find_if(before.begin(), before.end(),
                                  [&](const Handle &other) { return other.id == handle.id; });
    if (old == before.end())
      continue;
    const ExactVec3 at = handle.middle + (old->at - old->middle);
    handle.base += at - handle.at;
    handle.at = at;
  }
}

} // namespace halfspace
