#include "lessons/lesson/new_numbers/short_numbers.h"

#include "lessons/lesson/new_numbers/renewal.h"
#include "lessons/object/kind.h"
#include "lessons/object/kinds/number.h"
#include "lessons/scene/evaluation.h"

#include <algorithm>
#include <set>

namespace halfspace {
namespace {

/// Of the scenes that fit, the first few are compared: the shortest of all would often be the same.
constexpr int comparedScenes = 4;
/// A triangle whose corners were on one line is an ordinary one so often.
constexpr int ordinaryOnceIn = 3;
/// A result of 0 often means that nothing is left to calculate: it is no shorter than a fraction.
constexpr std::size_t lengthOfZero = 3;
/// What has no short form is longer than all that has.
constexpr std::size_t lengthOfLong = 1000;

/// The last construction and all that it follows from: nothing else has a say in what is shown as the result.
Scene shownPartOf(const Scene &scene) {
  std::set<std::string> needed;
  std::vector<std::size_t> places; // from below
  for (std::size_t i = scene.entries.size(); i-- > 0;) {
    const Entry &entry = scene.entries[i];
    const auto *use = std::get_if<ConstructionUse>(&entry.content);
    const bool isLastUse = use && needed.empty();
    if (!isLastUse && !needed.contains(entry.name))
      continue;
    for (const std::string &id : referencesIn(entry))
      needed.insert(ownerOf(id));
    places.push_back(i);
  }
  std::reverse(places.begin(), places.end());
  Scene part;
  for (const std::size_t place : places)
    part.entries.push_back(scene.entries.shared(place));
  return part;
}

std::vector<std::string> namesOfObjects(const Scene &scene) {
  std::vector<std::string> names;
  for (const Entry &entry : scene.entries)
    if (std::holds_alternative<Object>(entry.content) && !entry.isLocked)
      names.push_back(entry.name);
  return names;
}

/// A construction has none of its own, what is locked stays, a plain number keeps its one, as it may be a
/// bound or a step, and a mesh stays where others stand around it.
bool keepsItsNumbers(const Entry &entry) {
  const auto *object = std::get_if<Object>(&entry.content);
  return !object || entry.isLocked || kindOf(*object) == NumberObject::kind || object->shape();
}

bool differEverywhere(const Scene &a, const Scene &b) {
  return std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(),
                    [](const Entry &x, const Entry &y) { return keepsItsNumbers(x) || !(x == y); });
}

std::size_t lengthOf(const Surd &number) {
  if (number == Surd(0))
    return lengthOfZero;
  const auto text = toText(number);
  return text ? text->size() : lengthOfLong;
}

std::size_t lengthOf(const std::vector<NamedValue> &values) {
  std::size_t length = 0;
  for (const NamedValue &value : values)
    length += std::visit(Overloaded{[](const Surd &number) { return lengthOf(number); },
                                    [](const std::vector<Surd> &numbers) {
                                      std::size_t sum = 0;
                                      for (const Surd &number : numbers)
                                        sum += lengthOf(number);
                                      return sum;
                                    },
                                    [](const std::vector<NamedValue> &group) { return lengthOf(group); },
                                    [](const auto &) { return std::size_t(0); }},
                         value.value);
  return length;
}

/// Keeps the shortest of the first few scenes.
class Shortest {
public:
  [[nodiscard]] bool isFull() const { return m_count == comparedScenes; }
  void compare(Scene scene, std::size_t length) {
    if (isFull())
      return;
    ++m_count;
    if (!m_scene || length < m_length) {
      m_scene = std::move(scene);
      m_length = length;
    }
  }
  [[nodiscard]] const std::optional<Scene> &scene() const { return m_scene; }

private:
  std::optional<Scene> m_scene;
  std::size_t m_length = 0;
  int m_count = 0;
};

/// The shortest of some new scenes. With the case of `before` if that is wanted and no degenerate one; no new
/// scene is degenerate where `before` is not. Those of which the same is told beside numbers come first.
std::optional<Scene> renewed(const Scene &before, Dice &dice, const WantedNumbers &wanted) {
  const Evaluation start = evaluate(before);
  if (!start.lastConstruction())
    return before; // nothing is shown as the result
  const Outcome &present = *start.lastConstruction()->outcome;
  const std::vector<std::string> lines = present.explanation->ids();
  const bool keepsCornersOnALine =
      present.told->degenerate && !(wanted.keepCase && dice.once(ordinaryOnceIn));
  Shortest alike;
  Shortest others;
  for (int tried = 0; tried < mostNumbersTried && !alike.isFull(); ++tried) {
    Scene scene = before;
    renewAll(scene, namesOfObjects(scene), dice, keepsCornersOnALine);
    if (!differEverywhere(scene, before) || (wanted.suits && !wanted.suits(scene)))
      continue;
    const Evaluation evaluation = evaluate(scene);
    const Outcome &outcome = *evaluation.lastConstruction()->outcome;
    const bool isOfItsCase = outcome.told->name == present.told->name;
    const bool isAllowed =
        present.told->degenerate || (!outcome.told->degenerate && (!wanted.keepCase || isOfItsCase));
    if (!isAllowed)
      continue;
    Shortest &kept =
        !wanted.keepCase || (isOfItsCase && outcome.explanation->ids() == lines) ? alike : others;
    kept.compare(std::move(scene), lengthOf(*outcome.values));
  }
  return alike.scene() ? alike.scene() : others.scene();
}

} // namespace

Scene withShortNumbers(Scene scene, std::uint64_t seed, const WantedNumbers &wanted) {
  Dice dice(seed);
  const auto last = renewed(shownPartOf(scene), dice, wanted);
  if (!last)
    return scene;
  std::vector<std::string> others;
  for (const std::string &name : namesOfObjects(scene))
    if (const Object *found = findObject(*last, name))
      setObject(scene, name, *found);
    else
      others.push_back(name);
  renewAll(scene, others, dice);
  return scene;
}

} // namespace halfspace
