#include "lessons/scene/nearest_special_case.h"

#include "lessons/object/coordinate_limits.h"

namespace halfspace {
namespace {

/// The square of the way between two values of an object, of all its coordinates together.
Rational squareOfWay(const Object &from, const Object &to) {
  Rational square = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    const ExactVec3 way = to[i] - from[i];
    square += dot(way, way);
  }
  return square;
}

} // namespace

std::optional<NearestSpecialCase> nearestSpecialCase(const Scene &scene, const Evaluation &evaluation,
                                                     const std::set<std::string> &entries) {
  std::optional<NearestSpecialCase> nearest;
  std::optional<Rational> least;
  for (const Entry &entry : scene.entries) {
    const auto *use = std::get_if<ConstructionUse>(&entry.content);
    const EvaluatedEntry *found = evaluation.find(entry.name);
    if (!use || !found || !entries.contains(entry.name))
      continue;
    for (const SpecialCase &special : *found->outcome->nearby) {
      const std::string &name = use->roles.at(special.role).ids.at(special.place);
      const Object *object = findObject(scene, name); // null for what a construction makes
      if (!object || kindOf(*object) != kindOf(special.object) || refusedCoordinateOf(special.object))
        continue;
      const Rational square = squareOfWay(*object, special.object);
      if (least && square >= *least)
        continue;
      least = square;
      nearest = NearestSpecialCase{special.sentence, Surd::root(square), {name, special.object}};
    }
  }
  return nearest;
}

} // namespace halfspace
