#include "lessons/scene/near_special_cases.h"

#include "lessons/object/bound_point.h"
#include "lessons/object/coordinate_limits.h"
#include "lessons/object/kind.h"

#include <algorithm>

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

/// What the scene's object of a name would have to be, and how far that is; nothing where nobody can bring it
/// there.
struct Move {
  std::optional<Object> value; ///< nothing where it would have roots
  Surd square;                 ///< of the way, in space
};

/// A point that lies on another object keeps to it.
std::optional<Move> moveOnHost(const EvaluatedEntry &entry, const Object &bound, const ExactVec3 &place) {
  if (entry.looksAt.size() != 2)
    return {};
  const Object &host = entry.looksAt[1]->object;
  Object moved = bound.kind().binding->nearest(bound, host, place);
  if (!entry.missing.empty() || placeOn(moved, host) != place)
    return {};
  const ExactVec3 way = place - entry.looksAt[0]->object[0];
  return Move{std::move(moved), dot(way, way)};
}

std::optional<Move> moveTo(const SpecialCase &special, const std::string &name, const Scene &scene,
                           const Evaluation &evaluation) {
  const Object *now = findObject(scene, name); // null for what a construction makes
  const EvaluatedEntry *entry = evaluation.find(name);
  if (!now || !entry)
    return {};
  if (!special.object)
    return Move{{}, *special.rootedWay};
  std::optional<Move> move;
  const Object &there = *special.object;
  if (now->kind().binding && kindOf(there) == seenKindOf(*now))
    move = moveOnHost(*entry, *now, there[0]);
  else if (kindOf(there) == kindOf(*now))
    move = {there, squareOfWay(*now, there)};
  return move && !refusedCoordinateOf(*move->value) ? move : std::nullopt;
}

} // namespace

std::vector<NearSpecialCase> specialCasesNear(const Scene &scene, const Evaluation &evaluation,
                                              const std::set<std::string> &entries) {
  std::vector<NearSpecialCase> all;
  for (const Entry &entry : scene.entries) {
    const auto *use = std::get_if<ConstructionUse>(&entry.content);
    const EvaluatedEntry *found = evaluation.find(entry.name);
    if (!use || !found || !entries.contains(entry.name))
      continue;
    for (const SpecialCase &special : *found->outcome->nearby) {
      const std::string &name = use->roles.at(special.role).ids.at(special.place);
      const auto move = moveTo(special, name, scene, evaluation);
      if (!move)
        continue;
      NearSpecialCase near{entry.name, special.when, special.sentence, move->square, {}};
      if (move->value)
        near.change = ChangeObject{name, *move->value};
      all.push_back(std::move(near));
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const NearSpecialCase &a, const NearSpecialCase &b) {
    return a.squareOfWay < b.squareOfWay;
  });
  std::vector<NearSpecialCase> nearest;
  for (NearSpecialCase &near : all)
    if (std::none_of(nearest.begin(), nearest.end(),
                     [&](const NearSpecialCase &other) { return other.sentence == near.sentence; }))
      nearest.push_back(std::move(near));
  return nearest;
}

} // namespace halfspace
