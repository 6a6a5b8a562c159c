#include "lessons/scene/session.h"

#include "lessons/construction/construction.h"
#include "lessons/object/object_marks.h"
#include "lessons/words.h"

#include <algorithm>
#include <set>
#include <unordered_map>

namespace halfspace {
namespace {

/// A construction's outcome with what it was made from.
struct Evaluated {
  const Entry *entry;
  Outcome outcome;

  const ConstructionUse &use() const { return std::get<ConstructionUse>(entry->content); }
};

/// The objects in the order of the roles; nothing where one is missing or of another kind.
std::optional<std::vector<const Object *>> objectsFor(const Construction &construction,
                                                      const ConstructionUse &use, const Scene &scene) {
  std::vector<const Object *> objects;
  for (const ConstructionRole &role : construction.roles) {
    const auto bound = use.roles.find(role.name);
    const Object *object = bound == use.roles.end() ? nullptr : findObject(scene, bound->second);
    if (!object || kindOf(*object) != role.kind)
      return {};
    objects.push_back(object);
  }
  return objects;
}

std::vector<Evaluated> evaluateConstructions(const Scene &scene) {
  std::vector<Evaluated> evaluated;
  for (const Entry &entry : scene.entries) {
    const auto *use = std::get_if<ConstructionUse>(&entry.content);
    const Construction *construction = use ? findConstruction(use->id) : nullptr;
    if (!construction)
      continue;
    if (const auto objects = objectsFor(*construction, *use, scene))
      evaluated.push_back({&entry, construction->evaluate(*objects)});
  }
  return evaluated;
}

/// Adds an earlier construction's marks; their ids get the entry's name in front. What the last construction
/// draws just so is left out: `last` has its marks by their ids.
void addMarksOf(Evaluated &&earlier, const std::unordered_map<std::string, Mark> &last, Figure &figure) {
  for (Mark &mark : earlier.outcome.figure.marks) {
    MarkBase &base = baseOf(mark);
    if (const auto same = last.find(base.id); same != last.end() && same->second == mark)
      continue;
    base.id = earlier.entry->name + "." + base.id;
    figure.marks.push_back(std::move(mark));
  }
}

void addObjectsNotLookedAt(const Scene &scene, const std::vector<Evaluated> &evaluated, Figure &figure) {
  std::set<std::string> drawn;
  for (const Evaluated &each : evaluated)
    for (const auto &[role, name] : each.use().roles)
      drawn.insert(name);
  for (const Entry &entry : scene.entries)
    if (const auto *object = std::get_if<Object>(&entry.content); object && !drawn.contains(entry.name))
      for (Mark &mark : marksOf(entry.name, *object))
        figure.marks.push_back(std::move(mark));
}

bool hasTooManyDigits(const Integer &value) {
  return Integer(mp::abs(value)).str().size() > coordinateDigits;
}

bool isWithinBounds(const Object &object) {
  for (std::size_t index = 0; index < coordinatesOf(object).size(); ++index)
    for (int axis = 0; axis < 3; ++axis)
      if (refuseCoordinate(coordinate(object, index)[axis]))
        return false;
  return true;
}

} // namespace

std::string sentenceForTooLarge() {
  return words("This number is too large: coordinates go from −{limit} to {limit}.",
               {{"limit", toText(coordinateLimit)}});
}

std::string sentenceForTooLong() {
  return words("This number is too long: as a fraction it may have {digits} digits above and below the line.",
               {{"digits", std::to_string(coordinateDigits)}});
}

std::optional<std::string> refuseCoordinate(const Rational &value) {
  if (abs(value) > coordinateLimit)
    return sentenceForTooLarge();
  if (hasTooManyDigits(value.numerator()) || hasTooManyDigits(value.denominator()))
    return sentenceForTooLong();
  return {};
}

Session apply(Session session, const Edit &edit) {
  Object *object = findObject(session.scene, edit.object);
  if (object && object->index() == edit.value.index() && isWithinBounds(edit.value))
    *object = edit.value;
  return session;
}

Outcome evaluate(const Scene &scene) {
  std::vector<Evaluated> evaluated = evaluateConstructions(scene);
  Figure others;
  addObjectsNotLookedAt(scene, evaluated, others);
  Outcome outcome;
  if (!evaluated.empty()) {
    outcome = std::move(evaluated.back().outcome);
    std::unordered_map<std::string, Mark> last;
    for (const Mark &mark : outcome.figure.marks)
      last.emplace(baseOf(mark).id, mark);
    for (std::size_t i = 0; i + 1 < evaluated.size(); ++i)
      addMarksOf(std::move(evaluated[i]), last, outcome.figure);
  }
  std::move(others.marks.begin(), others.marks.end(), std::back_inserter(outcome.figure.marks));
  return outcome;
}

} // namespace halfspace
