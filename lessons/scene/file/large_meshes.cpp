#include "lessons/scene/file/large_meshes.h"

#include "lessons/scene/edit.h"
#include "lessons/scene/file/shape_text.h"

namespace halfspace {
bool isTooLargeToWrite(const Object &object) {
  return object.shape() && object.shape()->triangleCount() > mostWrittenTriangles;
}

std::vector<std::string> largeMeshes(const Scene &scene) {
  std::vector<std::string> names;
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content); object && isTooLargeToWrite(*object))
      names.push_back(entry.name);
  return names;
}

Scene withoutLargeMeshes(Scene scene) {
  for (const std::string &name : largeMeshes(scene)) {
    std::vector<Edit> edits = editsToUnlist(scene, name);
    edits.emplace_back(RemoveEntry{name, true});
    for (const Edit &edit : edits)
      if (auto edited = apply(scene, edit)) // refused where nothing would be left in the list
        scene = std::move(*edited);
  }
  return scene;
}

} // namespace halfspace
