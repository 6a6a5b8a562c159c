#include "lessons/scene/file/scene_writer.h"

#include "lessons/formula/read_formula.h"
#include "lessons/object/kind.h"
#include "lessons/scene/file/shape_text.h"

#include <nlohmann/json.hpp>

namespace halfspace {
namespace {

using Json = nlohmann::ordered_json;

Json jsonOf(const ExactVec3 &value, CoordinateRole role) {
  if (numbersIn(role) == 1)
    return toText(value.x);
  return Json::array({toText(value.x), toText(value.y), toText(value.z)});
}

Json coordinatesJson(const Object &object) {
  const auto &specs = coordinatesOf(object);
  if (specs.front().name.empty())
    return jsonOf(coordinate(object, 0), specs.front().role);
  Json json;
  for (std::size_t index = 0; index < specs.size(); ++index)
    json[std::string(specs[index].name)] = jsonOf(coordinate(object, index), specs[index].role);
  if (object.shape()) {
    WrittenShape shape = written(*object.shape());
    json[cornersField] = std::move(shape.corners);
    json[facesField] = std::move(shape.faces);
  }
  return json;
}

Json formulasJson(const DerivedObject &derived) {
  const auto &specs = derived.kind->coordinates;
  if (derived.coordinates.size() == 1 && specs.front().goesByObject())
    return toText(derived.coordinates.front());
  Json json;
  for (std::size_t index = 0; index < derived.coordinates.size(); ++index)
    json[std::string(specs[index].name)] = toText(derived.coordinates[index]);
  return json;
}

/// The coordinates of a bound object, behind what it lies on.
Json bound(const std::string &host, const Json &coordinates) {
  Json json{{hostRole, host}};
  json.update(coordinates);
  return json;
}

/// What the entry is: its kind with its coordinates or formulas, or its construction with what that looks at.
Json contentJson(const Entry &entry) {
  if (const auto *object = std::get_if<Object>(&entry.content)) {
    const Json coordinates = coordinatesJson(*object);
    return {{std::string(kindOf(*object)), entry.on.empty() ? coordinates : bound(entry.on, coordinates)}};
  }
  if (const auto *derived = std::get_if<DerivedObject>(&entry.content))
    return {{std::string(derived->kind->word), formulasJson(*derived)}};
  const auto &use = std::get<ConstructionUse>(entry.content);
  return {{"construction", use.id}, {"of", rolesJson(use)}};
}

Json jsonOf(const Entry &entry) {
  Json json{{"name", entry.name}};
  json.update(contentJson(entry));
  if (entry.color)
    json[colorField] = nameOf(*entry.color);
  if (entry.line)
    json[strokeField] = nameOf(*entry.line);
  if (entry.label)
    json[labelField] = nameOf(*entry.label);
  if (entry.isHidden)
    json[hiddenField] = true;
  if (entry.isLocked)
    json[lockedField] = true;
  return json;
}

} // namespace

Json rolesJson(const ConstructionUse &use) {
  Json json = Json::object();
  for (const auto &[role, objects] : use.roles)
    if (objects.ids.size() == 1)
      json[role] = objects.ids.front();
    else
      json[role] = objects.ids;
  return json;
}

Json jsonOf(const Object &object) { return {{std::string(kindOf(object)), coordinatesJson(object)}}; }

Json jsonOf(const Scene &scene) {
  Json json = Json::array();
  for (const Entry &entry : scene.entries)
    json.push_back(jsonOf(entry));
  return json;
}

} // namespace halfspace
