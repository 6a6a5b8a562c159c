#include "lessons/typed/scene_names.h"

#include "lessons/object/kind.h"
#include "lessons/object/solid.h"
#include "lessons/scene/formula_names.h"

#include <algorithm>

namespace halfspace {

SceneNames::SceneNames(const Scene &scene) : m_objects(seenObjectsOf(scene)) {
  for (const Entry &entry : scene.entries) {
    m_entries.insert(entry.name);
    m_written.insert(writtenName(entry.name));
  }
}

std::vector<std::string> SceneNames::idsFor(const std::string &name) const {
  std::vector<std::string> own;
  std::vector<std::string> made;
  for (const SeenObject &object : m_objects) {
    const QualifiedName id = qualified(object.id);
    if (object.id == name)
      return {name};
    if (id.entry == name)
      own.push_back(object.id);
    else if (!id.entry.empty() && id.own == name)
      made.push_back(object.id);
  }
  if (m_entries.contains(name))
    return own;
  return made.size() == 1 ? made : std::vector<std::string>();
}

bool SceneNames::isName(std::string_view name) const {
  return m_entries.contains(name.substr(0, name.find('.')));
}

std::string SceneNames::find(const std::string &name, std::string_view kind) const {
  std::string found;
  for (const std::string &id : idsFor(name)) {
    const auto object = std::find_if(m_objects.begin(), m_objects.end(),
                                     [&](const SeenObject &each) { return each.id == id; });
    if (!canStandFor(kind, object->kind))
      continue;
    if (!found.empty())
      return {};
    found = id;
  }
  return found;
}

std::string_view SceneNames::kindOf(const std::string &name) const {
  const std::vector<std::string> ids = idsFor(name);
  if (ids.size() != 1)
    return {};
  return std::find_if(m_objects.begin(), m_objects.end(),
                      [&](const SeenObject &each) { return each.id == ids.front(); })
      ->kind;
}

std::vector<std::string> SceneNames::names() const {
  std::vector<std::string> names;
  names.reserve(m_objects.size());
  for (const SeenObject &object : m_objects)
    names.push_back(object.id);
  return names;
}

std::optional<SceneNames::Value> SceneNames::value(const std::string &name) const {
  std::string meant;
  const auto coordinate = coordinateNamed(name, [&](std::string_view part) -> const Kind * {
    const std::vector<std::string> ids = idsFor(std::string(part));
    if (ids.size() != 1)
      return nullptr;
    meant = ids.front();
    return findKind(kindOf(meant));
  });
  if (!coordinate)
    return {};
  return Value{meant + name.substr(coordinate->object.size()), coordinate->role};
}

} // namespace halfspace
