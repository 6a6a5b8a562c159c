#include "lessons/scene/scene.h"

#include "lessons/object/kind.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/sphere.h"

#include <algorithm>

namespace halfspace {
namespace {

const Object *objectIn(const Entry &entry) { return std::get_if<Object>(&entry.content); }

/// The name of a coordinate within its object; a point's goes by the point's own name.
std::string_view ownName(const Entry &entry, const Object &object, std::size_t index) {
  const auto &specs = coordinatesOf(object);
  return index < specs.size() && !specs[index].goesByObject() ? specs[index].name
                                                              : std::string_view(entry.name);
}

std::string_view ownName(const Scene &scene, const CoordinateId &id) {
  const Entry *entry = scene.entries.find(id.object);
  const Object *object = entry ? objectIn(*entry) : nullptr;
  return object ? ownName(*entry, *object, id.index) : std::string_view(id.object);
}

/// The coordinate that alone has this name within its object; nothing where none or several have it.
std::optional<CoordinateId> onlyOneCalled(const Scene &scene, std::string_view name) {
  std::optional<CoordinateId> found;
  for (const Entry &entry : scene.entries)
    if (const Object *object = objectIn(entry))
      for (std::size_t index = 0; index < coordinatesOf(*object).size(); ++index)
        if (ownName(entry, *object, index) == name) {
          if (found)
            return {};
          found = CoordinateId{entry.name, index};
        }
  return found;
}

void addCoordinates(const Entry &entry, std::vector<CoordinateId> &ids) {
  if (const Object *object = objectIn(entry))
    for (std::size_t index = 0; index < coordinatesOf(*object).size(); ++index)
      ids.push_back({entry.name, index});
}

/// Calls a function for the id of each object that an entry looks at.
template <class SomeEntry, class Function> void forEachReference(SomeEntry &entry, Function function) {
  if (auto *use = std::get_if<ConstructionUse>(&entry.content))
    for (auto &[role, objects] : use->roles)
      for (auto &id : objects.ids)
        function(id);
  if (auto *derived = std::get_if<DerivedObject>(&entry.content))
    for (auto &formula : derived->coordinates)
      forEachName(formula, function);
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

const Kind *kindOf(const Entry &entry) {
  if (const Object *object = objectIn(entry))
    return &object->kind();
  const auto *derived = std::get_if<DerivedObject>(&entry.content);
  return derived ? derived->kind : nullptr;
}

bool isDrawn(const Entry &entry) {
  const Kind *kind = kindOf(entry);
  return !kind || kind->draw != drawNothing || kind->binding;
}

bool hasLines(const Entry &entry) {
  const Kind *kind = kindOf(entry);
  return !kind || (isDrawn(entry) && !kind->shape && !kind->binding && kind->word != PointObject::kind &&
                   kind->word != SphereObject::kind);
}

bool areBuiltAlike(const Entry &a, const Entry &b) {
  const Object *first = objectIn(a);
  const Object *second = objectIn(b);
  const bool haveSameContent = first && second
                                   ? &first->kind() == &second->kind() && first->size() == second->size()
                                   : a.content == b.content;
  return a.name == b.name && a.on == b.on && haveSameContent;
}

bool areBuiltAlike(const Scene &a, const Scene &b) {
  return std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(), b.entries.end(),
                    [](const Entry &x, const Entry &y) { return areBuiltAlike(x, y); });
}

const Object *findObject(const Scene &scene, std::string_view name) {
  const Entry *entry = scene.entries.find(name);
  return entry ? objectIn(*entry) : nullptr;
}

void setObject(Scene &scene, std::string_view name, Object object) {
  scene.entries.change(scene.entries.placeOf(name).value(),
                       [&](Entry &entry) { entry.content = std::move(object); });
}

std::vector<CoordinateId> coordinatesOf(const Scene &scene) {
  std::vector<CoordinateId> ids;
  for (const Entry &entry : scene.entries)
    addCoordinates(entry, ids);
  return ids;
}

std::vector<CoordinateId> coordinatesOf(const Scene &scene, std::string_view name) {
  std::vector<CoordinateId> ids;
  if (const Entry *entry = scene.entries.find(name))
    addCoordinates(*entry, ids);
  return ids;
}

std::string fullName(const Scene &scene, const CoordinateId &id) {
  const std::string_view own = ownName(scene, id);
  return own == id.object ? id.object : id.object + "." + std::string(own);
}

std::string shortName(const Scene &scene, const CoordinateId &id) {
  const std::string_view own = ownName(scene, id);
  return onlyOneCalled(scene, own) ? std::string(own) : fullName(scene, id);
}

std::optional<CoordinateId> findCoordinate(const Scene &scene, std::string_view name) {
  for (const CoordinateId &id : coordinatesOf(scene, ownerOf(name)))
    if (fullName(scene, id) == name)
      return id;
  return onlyOneCalled(scene, name);
}

} // namespace halfspace
