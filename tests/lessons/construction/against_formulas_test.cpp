// Constructions that measure, and those of spheres, against formulas that are written otherwise: on ten
// thousand scenes of the smallest whole numbers, among which each special case comes up by itself.
#include "tests/lessons/construction/expected/expected.h"
#include "tests/lessons/construction/same_numbers.h"
#include "tests/test_name.h"

#include "lessons/construction/construction.h"
#include "lessons/object/corners.h"
#include "lessons/object/kind.h"
#include "lessons/object/solid.h"
#include "tests/effort.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace halfspace {
namespace {

using namespace test;

constexpr int scenes = effort(10'000);

class SmallObjects {
public:
  explicit SmallObjects(const Construction &construction) : m_construction(construction) {}

  std::vector<Object> next() {
    std::vector<Object> objects;
    for (const ConstructionRole &role : m_construction.roles) {
      const auto words = kindsSeenAs(role.kind);
      objects.push_back(*makeObject(words[static_cast<std::size_t>(integer(0, int(words.size()) - 1))]));
      fill(objects.back());
    }
    return objects;
  }

private:
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }

  void fill(Object &object) {
    for (int more = integer(0, 3); more > 0 && object.size() < object.kind().coordinates.size(); --more)
      object.addVertex();
    for (std::size_t i = 0; i < object.size(); ++i)
      object[i] = numbersIn(coordinatesOf(object)[i].role) == 1
                      ? ExactVec3(integer(0, 3), 0, 0)
                      : ExactVec3(integer(-2, 2), integer(-2, 2), integer(-2, 2));
    if (integer(0, 2) > 0) // more than three corners are seldom in a plane by chance
      for (const std::size_t corner : cornersOf(object))
        object[corner].z = object[corner].x;
    object.kind().settle(object);
  }

  const Construction &m_construction;
  std::mt19937_64 m_engine{20};
};

/// All values but words, by their names, those of a group as `first.point`.
void addNumbers(const std::vector<NamedValue> &values, const std::string &group,
                std::map<std::string, std::vector<Surd>> &numbers) {
  for (const NamedValue &value : values)
    if (const auto *members = std::get_if<std::vector<NamedValue>>(&value.value))
      addNumbers(*members, group + value.name + ".", numbers);
    else if (const auto *number = std::get_if<Surd>(&value.value))
      numbers[group + value.name] = {*number};
    else
      numbers[group + value.name] = std::get<std::vector<Surd>>(value.value);
}

void expectSame(const Outcome &outcome, const Recomputed &expected) {
  EXPECT_EQ(outcome.told->name, expected.caseName);
  EXPECT_EQ(outcome.told->degenerate, expected.degenerate);
  std::map<std::string, std::vector<Surd>> numbers;
  addNumbers(*outcome.values, "", numbers);
  EXPECT_EQ(numbers.size(), expected.values.size());
  for (const auto &[name, value] : numbers) {
    const auto other = expected.values.find(name);
    ASSERT_NE(other, expected.values.end()) << name;
    EXPECT_TRUE(areSame(value, other->second)) << name;
  }
}

std::string textOf(const std::vector<Object> &objects) {
  std::string text;
  for (const Object &object : objects) {
    text += std::string(kindOf(object));
    for (std::size_t i = 0; i < object.size(); ++i)
      text += " (" + toText(object[i].x) + ", " + toText(object[i].y) + ", " + toText(object[i].z) + ")";
    text += "; ";
  }
  return text;
}

class AgainstFormulas : public testing::TestWithParam<std::string> {};

TEST_P(AgainstFormulas, OnManySmallIntegers_IsTheSameInEveryCase) {
  const Construction &construction = *findConstruction(GetParam());
  SmallObjects random(construction);
  std::set<std::string> cases;
  for (int i = 0; i < scenes && !HasFailure(); ++i) {
    const std::vector<Object> objects = random.next();
    SCOPED_TRACE(textOf(objects));
    std::vector<const Object *> pointers;
    for (const Object &object : objects)
      pointers.push_back(&object);
    const Evaluation evaluation = evaluate(sceneOf(construction, objects));
    const Outcome &outcome = lastOutcome(evaluation);
    cases.insert(outcome.told->name);
    expectSame(outcome, expectedOf(construction).recompute(pointers));
  }
  if (isWatched)
    return; // too few to come to all
  const auto &all = construction.names.cases;
  EXPECT_EQ(cases, std::set<std::string>(all.begin(), all.end()));
}

INSTANTIATE_TEST_SUITE_P(Measures, AgainstFormulas,
                         testing::Values("line-sphere", "plane-sphere", "circumsphere", "circumsphere-points",
                                         "triangle-area", "polygon-area", "solid-volume"),
                         test::testName);

} // namespace
} // namespace halfspace
