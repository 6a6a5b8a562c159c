#include "lessons/scene/scene_checker.h"

#include "lessons/construction/construction.h"
#include "lessons/guess.h"
#include "lessons/object/coordinate_limits.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/solid.h"
#include "lessons/scene/formula_names.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <map>

namespace halfspace {
namespace {

Problem problemWith(std::string field, std::string sentence) {
  return {std::move(sentence), "", 0, std::move(field)};
}

bool isNameCharacter(char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '-' || c == '_'; }

std::vector<std::string> idsOfConstructions() {
  std::vector<std::string> ids;
  for (const Construction &construction : constructions())
    ids.emplace_back(construction.id);
  return ids;
}

/// No object stands twice: its letters would mean two things.
std::optional<Problem> checkTwice(const ConstructionUse &use) {
  std::map<std::string, std::string> roleOf;
  for (const auto &[role, objects] : use.roles)
    for (const std::string &id : objects.ids)
      if (const auto [before, isNew] = roleOf.emplace(id, role); !isNew)
        return problemWith(
            "of." + shortened(role),
            before->second == role
                ? words("“{name}” stands twice in this list: name it once.", {{"name", shortened(id)}})
                : words("“{name}” stands in two roles: name another object in one of them.",
                        {{"name", shortened(id)}}));
  return {};
}

/// Whether the entry can look as it is to look: what is not drawn has no look.
std::optional<Problem> checkLook(const Entry &entry) {
  const bool isSeen = isDrawn(entry);
  if (entry.color && !isSeen)
    return problemWith(colorField, words("“{name}” has no colour of its own.", {{"name", entry.name}}));
  if (entry.line && !hasLines(entry))
    return problemWith(strokeField, words("“{name}” has no lines of its own.", {{"name", entry.name}}));
  if ((entry.isHidden || entry.label) && !isSeen)
    return problemWith(entry.isHidden ? hiddenField : labelField,
                       words("“{name}” is a number: it is in no picture.", {{"name", entry.name}}));
  if (entry.isLocked && !(kindOf(entry) && isSeen))
    return problemWith(lockedField, words("No hand moves “{name}” anyway.", {{"name", entry.name}}));
  return {};
}

} // namespace

bool canBeName(std::string_view name) {
  return !name.empty() && name.size() <= maxNameLength && isLetter(name.front()) &&
         std::all_of(name.begin(), name.end(), isNameCharacter);
}

Problem tooManyEntries() {
  return problemWith("", words("The scene is too large: it may have {limit} entries.",
                               {{"limit", std::to_string(maxSceneEntries)}}));
}

std::optional<Problem> refuseUnfitting(const Object &object) {
  Object settled = object;
  object.kind().settle(settled);
  const auto specs = coordinatesOf(object);
  for (std::size_t i = 0; i < specs.size(); ++i)
    for (int axis = 0; axis < numbersIn(specs[i].role); ++axis)
      if (const Rational &number = object[i][axis]; number != settled[i][axis])
        return problemWith(std::string(specs[i].name),
                           words("“{name}” cannot be {value} here: {fitting} is the nearest that fits.",
                                 {{"name", std::string(specs[i].name)},
                                  {"value", toText(number)},
                                  {"fitting", toText(settled[i][axis])}}));
  return {};
}

std::optional<Problem> SceneChecker::check(const Entry &entry) {
  if (m_names.size() == maxSceneEntries)
    return tooManyEntries();
  if (auto problem = checkName(entry.name))
    return problem;
  m_names.insert(entry.name);
  if (auto problem = checkLook(entry))
    return problem;
  if (const auto *object = std::get_if<Object>(&entry.content)) {
    if (auto problem = checkHost(entry, *object))
      return problem;
    m_kinds.emplace(entry.name, object->kind().binding ? seenKindOf(*object) : kindOf(*object));
    if (const auto refused = refusedCoordinateOf(*object))
      return problemWith(std::string(refused->name), refused->sentence);
    return refuseUnfitting(*object);
  }
  if (const auto *derived = std::get_if<DerivedObject>(&entry.content)) {
    if (auto problem = checkDerived(*derived)) // before its name is known: it cannot follow itself
      return problem;
    m_kinds.emplace(entry.name, derived->kind->word);
    return {};
  }
  const auto &use = std::get<ConstructionUse>(entry.content);
  if (auto problem = checkUse(use))
    return problem;
  for (const ConstructionRole &made : findConstruction(use.id)->makes) {
    m_kinds.emplace(entry.name + "." + made.name, made.kind);
    m_makers[made.name].push_back(entry.name);
  }
  return {};
}

std::string SceneChecker::idOf(const std::string &name) const {
  const auto makers = m_makers.find(name);
  const bool isMadeByOne = !m_names.contains(name) && makers != m_makers.end() && makers->second.size() == 1;
  return isMadeByOne ? makers->second.front() + "." + name : name;
}

std::optional<Problem> SceneChecker::checkName(const std::string &name) const {
  if (!canBeName(name))
    return problemWith(
        "name",
        words("“{name}” cannot be a name: names are at most {limit} letters A–Z, digits, - and _, and begin "
              "with a letter.",
              {{"name", shortened(name)}, {"limit", std::to_string(maxNameLength)}}));
  if (m_names.contains(name))
    return problemWith(
        "name",
        words("The name “{name}” is taken by an entry above. Every name may stand once.", {{"name", name}}));
  return {};
}

std::vector<std::string> SceneChecker::objectsOfKind(std::string_view kind) const {
  std::vector<std::string> ids;
  for (const auto &[id, its] : m_kinds)
    if (canStandFor(kind, its))
      ids.push_back(id);
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::optional<Problem> SceneChecker::checkReference(const std::string &field, const std::string &id,
                                                    std::string_view expected) const {
  const auto kind = m_kinds.find(id);
  if (kind == m_kinds.end())
    return problemWith(
        field, withGuess(words("Above this entry there is no object “{name}”.", {{"name", shortened(id)}}),
                         id, objectsOfKind(expected)));
  if (!canStandFor(expected, kind->second))
    return problemWith(field,
                       words("Here {kind} is expected, but “{name}” is {other}.",
                             {{"kind", nounOf(expected)}, {"name", id}, {"other", nounOf(kind->second)}}));
  return {};
}

std::optional<Problem> SceneChecker::checkHost(const Entry &entry, const Object &object) const {
  const std::string field = std::string(kindOf(object)) + "." + hostRole;
  if (const auto &binding = object.kind().binding)
    return checkReference(field, entry.on, binding->host);
  if (entry.on.empty())
    return {};
  return problemWith(field, words("“{name}” is {kind}, which lies on nothing.",
                                  {{"name", entry.name}, {"kind", object.kind().noun()}}));
}

std::optional<Problem> SceneChecker::checkDerived(const DerivedObject &derived) const {
  const Kind &kind = *derived.kind;
  const std::size_t count = derived.coordinates.size();
  const bool isNumber = kind.word == NumberObject::kind;
  if (kind.binding || kind.shape || count > kind.coordinates.size() ||
      (isNumber ? count != 1 : count < kind.fewestCoordinates()))
    return problemWith("", words("This is {kind}: it cannot follow others so.", {{"kind", kind.noun()}}));
  for (std::size_t index = 0; index < count; ++index)
    if (auto problem = checkFormula(kind.coordinates[index], std::string(kind.coordinates[index].name),
                                    derived.coordinates[index]))
      return problem;
  return {};
}

std::optional<FormulaShape> SceneChecker::shapeNamed(std::string_view name) const {
  const auto coordinate = coordinateNamed(name, [&](std::string_view id) -> const Kind * {
    const auto kind = m_kinds.find(std::string(id));
    return kind == m_kinds.end() ? nullptr : findKind(kind->second);
  });
  if (!coordinate)
    return {};
  return numbersIn(coordinate->role) == 1 ? FormulaShape::Number : FormulaShape::Triple;
}

std::optional<Problem> SceneChecker::checkFormula(const CoordinateSpec &spec, const std::string &field,
                                                  const Formula &formula) const {
  std::optional<Problem> problem;
  forEachName(formula, [&](const std::string &name) {
    if (!problem && !shapeNamed(name))
      problem = m_kinds.contains(name)
                    ? problemWith(field,
                                  words("“{name}” is {kind}: a formula is about numbers, points and vectors.",
                                        {{"name", name}, {"kind", nounOf(m_kinds.at(name))}}))
                    : checkReference(field, name, PointObject::kind);
  });
  if (problem)
    return problem;
  const auto shape = shapeOf(formula, [&](std::string_view name) { return shapeNamed(name); });
  if (const auto *fault = std::get_if<FormulaFault>(&shape))
    return problemWith(field, fault->sentence);
  const bool isNumber = numbersIn(spec.role) == 1;
  if (isNumber == (std::get<FormulaShape>(shape) == FormulaShape::Number))
    return {};
  return problemWith(field, isNumber ? words("Here a number is expected, not a point or a vector.")
                                     : words("Here three numbers are expected, as (1, 2, 3)."));
}

std::optional<Problem> SceneChecker::checkRole(const ConstructionRole &role,
                                               const ConstructionUse &use) const {
  const std::string field = "of." + role.name;
  const auto bound = use.roles.find(role.name);
  if (bound == use.roles.end())
    return problemWith(field, role.isList
                                  ? words("This construction looks at a list {role}: name {kind} or several.",
                                          {{"kind", nounOf(role.kind)}, {"role", role.name}})
                                  : words("This construction looks at {kind} {role}: name one.",
                                          {{"kind", nounOf(role.kind)}, {"role", role.name}}));
  const std::vector<std::string> &ids = bound->second.ids;
  if (!isCountOf(role, ids.size()))
    return problemWith(field, role.isList
                                  ? words("Here a list of 1 to {limit} objects is expected, as [E, F].",
                                          {{"limit", std::to_string(maxListedObjects)}})
                                  : words("Here one object is expected, not a list of them."));
  for (const std::string &id : ids)
    if (auto problem = checkReference(field, id, role.kind))
      return problem;
  return {};
}

std::optional<Problem> SceneChecker::checkUse(const ConstructionUse &use) const {
  const Construction *construction = findConstruction(use.id);
  if (!construction)
    return problemWith(
        "construction",
        withGuess(
            words("There is no construction “{id}”. Mend the name, or use a newer version of Halfspace.",
                  {{"id", shortened(use.id)}}),
            use.id, idsOfConstructions()));
  for (const ConstructionRole &role : construction->roles)
    if (auto problem = checkRole(role, use))
      return problem;
  if (auto problem = checkTwice(use))
    return problem;
  for (const auto &[role, objects] : use.roles)
    if (std::none_of(construction->roles.begin(), construction->roles.end(),
                     [&role = role](const ConstructionRole &known) { return known.name == role; }))
      return problemWith(
          "of." + shortened(role),
          words("This construction looks at nothing by the name “{role}”.", {{"role", shortened(role)}}));
  return {};
}

std::optional<Problem> checkScene(const Scene &scene) {
  SceneChecker checker;
  for (const Entry &entry : scene.entries)
    if (auto problem = checker.check(entry))
      return problem;
  return {};
}

} // namespace halfspace
