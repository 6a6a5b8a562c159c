#include "lessons/scene/scene.h"

#include <algorithm>

namespace halfspace {
namespace {

/// The name of a coordinate within its object; a point's goes by the point's own name.
std::string_view ownName(const Entry &entry, const Object &object, std::size_t index) {
  const auto &specs = coordinatesOf(object);
  return index < specs.size() && !specs[index].goesByObject() ? specs[index].name
                                                              : std::string_view(entry.name);
}

std::string_view ownName(const Scene &scene, const CoordinateId &id) {
  for (const Entry &entry : scene.entries)
    if (entry.name == id.object)
      if (const auto *object = std::get_if<Object>(&entry.content))
        return ownName(entry, *object, id.index);
  return id.object;
}

bool isOnlyOne(const Scene &scene, std::string_view name) {
  int found = 0;
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content))
      for (std::size_t index = 0; index < coordinatesOf(*object).size(); ++index)
        found += ownName(entry, *object, index) == name ? 1 : 0;
  return found == 1;
}

/// Calls a function for the id of each object that an entry looks at.
template <class SomeEntry, class Function> void forEachReference(SomeEntry &entry, Function function) {
  if (auto *use = std::get_if<ConstructionUse>(&entry.content))
    for (auto &[role, objects] : use->roles)
      for (auto &id : objects.ids)
        function(id);
  if (!entry.on.empty())
    function(entry.on);
}

} // namespace

std::vector<std::string> referencesIn(const Entry &entry) {
  std::vector<std::string> ids;
  forEachReference(entry, [&](const std::string &id) { ids.push_back(id); });
  return ids;
}

std::vector<std::string *> referencesIn(Entry &entry) {
  std::vector<std::string *> ids;
  forEachReference(entry, [&](std::string &id) { ids.push_back(&id); });
  return ids;
}

const Object *findObject(const Scene &scene, std::string_view name) {
  for (const Entry &entry : scene.entries)
    if (entry.name == name)
      return std::get_if<Object>(&entry.content);
  return nullptr;
}

Object *findObject(Scene &scene, std::string_view name) {
  for (Entry &entry : scene.entries)
    if (entry.name == name)
      return std::get_if<Object>(&entry.content);
  return nullptr;
}

std::vector<CoordinateId> coordinatesOf(const Scene &scene) {
  std::vector<CoordinateId> ids;
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content))
      for (std::size_t index = 0; index < coordinatesOf(*object).size(); ++index)
        ids.push_back({entry.name, index});
  return ids;
}

std::string fullName(const Scene &scene, const CoordinateId &id) {
  const std::string_view own = ownName(scene, id);
  return own == id.object ? id.object : id.object + "." + std::string(own);
}

std::string shortName(const Scene &scene, const CoordinateId &id) {
  const std::string_view own = ownName(scene, id);
  return isOnlyOne(scene, own) ? std::string(own) : fullName(scene, id);
}

std::optional<CoordinateId> findCoordinate(const Scene &scene, std::string_view name) {
  const auto ids = coordinatesOf(scene);
  for (const CoordinateId &id : ids)
    if (fullName(scene, id) == name)
      return id;
  for (const CoordinateId &id : ids)
    if (ownName(scene, id) == name && isOnlyOne(scene, name))
      return id;
  return {};
}

} // namespace halfspace
