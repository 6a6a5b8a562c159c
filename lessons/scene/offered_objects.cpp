#include "lessons/scene/offered_objects.h"

#include "lessons/scene/formula_names.h"

#include <algorithm>

namespace halfspace {

const OfferedObject *findOffered(const Evaluation &evaluation, std::string_view id) {
  const EvaluatedEntry *entry = evaluation.entries.find(ownerOf(id));
  if (!entry)
    return nullptr;
  const QualifiedName qualifiedId = qualified(id);
  const std::string_view name = qualifiedId.entry.empty() ? std::string_view() : qualifiedId.own;
  const auto found = std::find_if(entry->offers.begin(), entry->offers.end(),
                                  [&](const OfferedObject &each) { return each.name == name; });
  return found == entry->offers.end() ? nullptr : &*found;
}

std::string sourceOf(const Scene &scene, std::string name) {
  const auto kindOfId = [&](std::string_view id) -> const Kind * {
    const Entry *entry = scene.entries.find(id);
    return entry ? kindOf(*entry) : nullptr;
  };
  // Each entry follows only what stands above it, so this comes to an end.
  for (auto place = coordinateNamed(name, kindOfId); place; place = coordinateNamed(name, kindOfId)) {
    const auto *derived = std::get_if<DerivedObject>(&scene.entries.find(place->object)->content);
    if (!derived || place->index >= derived->coordinates.size() ||
        derived->coordinates[place->index].kind != FormulaKind::Name)
      break;
    name = derived->coordinates[place->index].name;
  }
  return name;
}

std::optional<CoordinateValue> coordinateValue(const Evaluation &evaluation, std::string_view name) {
  const auto place = coordinateNamed(name, [&](std::string_view id) -> const Kind * {
    const OfferedObject *object = findOffered(evaluation, id);
    return object ? &object->given->object.kind() : nullptr;
  });
  if (!place)
    return {};
  const OfferedObject *object = findOffered(evaluation, place->object);
  if (!object->whyNot.empty())
    return {};
  return CoordinateValue{place->role, object->given->object[place->index]};
}

std::optional<ExactVec3> placeNamed(const Evaluation &evaluation, std::string_view name) {
  const auto coordinate = coordinateValue(evaluation, name);
  return coordinate && coordinate->role == CoordinateRole::Position ? std::optional(coordinate->value)
                                                                    : std::nullopt;
}

} // namespace halfspace
