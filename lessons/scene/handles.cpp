#include "lessons/scene/handles.h"

#include "lessons/object/kind.h"
#include "lessons/scene/scene_letters.h"

namespace halfspace {
namespace {

/// A position is grabbed where it is, a direction at its tip.
void addCoordinateHandles(const Given<Object> &given, std::vector<Handle> &handles) {
  const auto specs = coordinatesOf(given.object);
  for (std::size_t index = 0; index < specs.size(); ++index) {
    if (numbersIn(specs[index].role) == 1)
      continue;
    Handle handle;
    handle.id = coordinateId(given.id, specs[index]);
    handle.object = given.id;
    handle.coordinate = index;
    if (specs[index].role == CoordinateRole::Direction)
      handle.base = given.object[0];
    handle.at = handle.base + given.object[index];
    handles.push_back(std::move(handle));
  }
}

} // namespace

std::vector<Handle> handlesOf(const Scene &scene) {
  const SceneLetters letters(scene);
  std::vector<Handle> handles;
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content)) {
      const Given<Object> given = letters.given(entry.name, *object);
      addCoordinateHandles(given, handles);
      for (Handle &own : object->kind().ownHandles(given))
        handles.push_back(std::move(own));
    }
  return handles;
}

} // namespace halfspace
