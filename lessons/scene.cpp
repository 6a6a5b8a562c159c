#include "lessons/scene.h"

#include <algorithm>

namespace halfspace {
namespace {

/// The name of a coordinate within its object; a point's goes by the point's own name.
std::string_view ownName(const Scene &scene, const CoordinateId &id) {
  const Object *object = findObject(scene, id.object);
  if (!object || id.index >= coordinatesOf(*object).size())
    return id.object;
  const std::string_view name = coordinatesOf(*object)[id.index].name;
  return name.empty() ? std::string_view(id.object) : name;
}

bool isOnlyOne(const Scene &scene, std::string_view name) {
  const auto ids = coordinatesOf(scene);
  return std::count_if(ids.begin(), ids.end(),
                       [&](const CoordinateId &id) { return ownName(scene, id) == name; }) == 1;
}

} // namespace

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
