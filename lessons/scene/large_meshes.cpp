#include "lessons/scene/large_meshes.h"

#include "lessons/scene/edit.h"
#include "lessons/scene/shape_text.h"

namespace halfspace {
namespace {

/// The edits after which no list has this name among others.
std::vector<Edit> editsToUnlist(const Scene &scene, const std::string &name) {
  std::vector<Edit> edits;
  for (const Entry &entry : scene.entries)
    if (const auto *use = std::get_if<ConstructionUse>(&entry.content))
      for (const auto &[role, objects] : use->roles)
        if (RoleObjects others = objects; std::erase(others.ids, name) > 0)
          edits.emplace_back(RebindRole{entry.name, role, std::move(others)});
  return edits;
}

} // namespace

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
