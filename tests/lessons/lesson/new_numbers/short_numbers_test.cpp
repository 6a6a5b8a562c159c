// New numbers for a scene: the same case, short results, and never what was there.
#include "lessons/lesson/new_numbers/short_numbers.h"

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/new_numbers/renewal.h"
#include "tests/effort.h"
#include "tests/lessons/construction/construction_ids.h"
#include "tests/lessons/construction/random_objects.h"
#include "tests/lessons/scenes.h"
#include "tests/test_name.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace halfspace {
namespace {

using namespace test;

constexpr int seeds = effort(100);

/// A scene of each ordinary case of a construction, as the first seeds come upon it.
std::map<std::string, Scene> ordinaryScenes(const Construction &construction) {
  std::map<std::string, Scene> scenes;
  RandomObjects random(7);
  for (int i = 0; i < 400; ++i) {
    const Scene scene = sceneOf(construction, random.objectsFor(construction, Writing::SmallIntegers));
    if (!isDegenerate(scene))
      scenes.emplace(lastCase(scene), scene);
  }
  return scenes;
}

std::string textOf(const Scene &scene) {
  std::string text;
  for (const CoordinateId &id : coordinatesOf(scene)) {
    const ExactVec3 &at = coordinate(*findObject(scene, id.object), id.index);
    text += fullName(scene, id) + " = (" + toText(at.x) + ", " + toText(at.y) + ", " + toText(at.z) + ") ";
  }
  return text;
}

/// A plain number keeps its one.
bool isNumber(const Object &object) { return kindOf(object) == "number"; }

void expectShort(const Scene &scene) {
  for (const CoordinateId &id : coordinatesOf(scene)) {
    if (isNumber(*findObject(scene, id.object)))
      continue;
    const ExactVec3 &at = coordinate(*findObject(scene, id.object), id.index);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(at[axis].isInteger()) << textOf(scene);
      EXPECT_LE(abs(at[axis]), largestShortNumber) << textOf(scene);
    }
  }
}

/// All numbers among the results.
std::vector<Surd> numbersIn(const std::vector<NamedValue> &values) {
  std::vector<Surd> numbers;
  const auto append = [&](const std::vector<Surd> &more) {
    numbers.insert(numbers.end(), more.begin(), more.end());
  };
  for (const NamedValue &value : values)
    std::visit(Overloaded{[&](const Surd &number) { append({number}); },
                          [&](const std::vector<Surd> &list) { append(list); },
                          [&](const std::vector<NamedValue> &group) { append(numbersIn(group)); },
                          [](const auto &) {}},
               value.value);
  return numbers;
}

/// What can be reached by hand: the longest is the denominator of a vector's part along a normal (2, 3, 6).
/// What chance directs is not: there a factor is rounded to four digits.
void expectWithinReach(const Scene &scene) {
  const int largestDenominator = lastCase(scene) == "seeded" ? 10'000 : 49;
  const Evaluation evaluation = evaluate(scene);
  for (const Surd &number : numbersIn(*lastOutcome(evaluation).values)) {
    EXPECT_LE(abs(number.rootFactor().numerator()), 108);
    // A root divided by is one below: a cosine has the length of a normal beside it, up to 3.
    EXPECT_LE(number.rootFactor().denominator(), 3 * 108);
    EXPECT_LE(number.radicand(), 108 * 108);
    EXPECT_LE(abs(number.rationalPart().numerator()), 108 * 108);
    EXPECT_LE(number.rationalPart().denominator(), largestDenominator);
  }
}

bool shareAnObject(const Scene &a, const Scene &b) {
  for (std::size_t i = 0; i < a.entries.size(); ++i)
    if (const auto *object = std::get_if<Object>(&a.entries[i].content);
        object && !isNumber(*object) && a.entries[i] == b.entries[i])
      return true;
  return false;
}

} // namespace

class ShortNumbersOf : public testing::TestWithParam<std::string> {};

TEST_P(ShortNumbersOf, everyCase_keepItWithShortCoordinatesAndResults) {
  const auto scenes = ordinaryScenes(*findConstruction(GetParam()));
  EXPECT_FALSE(scenes.empty());
  for (const auto &[caseName, scene] : scenes) {
    SCOPED_TRACE(caseName);
    std::set<std::string> different;
    for (int seed = 0; seed < seeds; ++seed) {
      const Scene renewed = withShortNumbers(scene, static_cast<std::uint64_t>(seed));
      EXPECT_EQ(lastCase(renewed), caseName) << textOf(renewed);
      EXPECT_FALSE(isDegenerate(renewed));
      EXPECT_FALSE(shareAnObject(renewed, scene)) << textOf(renewed);
      expectShort(renewed);
      expectWithinReach(renewed);
      different.insert(textOf(renewed));
    }
    // Now and then two agree, most often where all that there is is one point.
    EXPECT_GT(different.size(), seeds * 0.9);
  }
}

INSTANTIATE_TEST_SUITE_P(EveryConstruction, ShortNumbersOf, testing::ValuesIn(constructionIds()), testName);

/// The words of a lesson would no longer hold else.
TEST(ShortNumbers, ofEveryLesson_areOthersWithTheSameLines) {
  for (const Lesson &lesson : readLessons(LESSON_FOLDER).lessons) {
    SCOPED_TRACE(lesson.id);
    const Evaluation before = evaluate(lesson.scene);
    for (int seed = 0; seed < effort(30); ++seed) {
      const Scene renewed = withShortNumbers(lesson.scene, static_cast<std::uint64_t>(seed));
      EXPECT_FALSE(shareAnObject(renewed, lesson.scene)) << textOf(renewed);
      const Evaluation after = evaluate(renewed);
      EXPECT_EQ(lastOutcome(after).explanation->ids(), lastOutcome(before).explanation->ids())
          << textOf(renewed);
    }
  }
}

TEST(ShortNumbers, again_areOthers) {
  Scene scene = distanceScene();
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Scene next = withShortNumbers(scene, seed);
    EXPECT_FALSE(shareAnObject(next, scene)) << textOf(next);
    scene = std::move(next);
  }
}

TEST(ShortNumbers, sameSeed_givesTheSameNumbers) {
  EXPECT_EQ(withShortNumbers(distanceScene(), 5), withShortNumbers(distanceScene(), 5));
  EXPECT_NE(withShortNumbers(distanceScene(), 5), withShortNumbers(distanceScene(), 6));
}

TEST(ShortNumbers, seed_givesTheSameNumbersEverywhere) {
  EXPECT_EQ(textOf(withShortNumbers(distanceScene(), 5)),
            "E.P0 = (-1, 1, -1) E.n = (1, -2, 2) Q = (-4, -1, 3) ");
  const Scene rays{{planeE(), rayL(), triangleT()}};
  EXPECT_EQ(textOf(withShortNumbers(rays, 5)),
            "E.P0 = (-1, 5, -3) E.n = (2, 3, -6) L.Q = (-1, 3, -1) L.r = (-1, -3, 2) "
            "T.P0 = (-2, 6, 0) T.P1 = (-5, 9, 6) T.P2 = (-2, 9, 3) ");
}

TEST(ShortNumbers, degenerateScene_becomesAnOrdinaryOne) {
  Scene scene = distanceScene();
  setCoordinate(scene, {"E", 1}, {0, 0, 0});
  ASSERT_TRUE(isDegenerate(scene));
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    EXPECT_FALSE(isDegenerate(withShortNumbers(scene, seed)));
}

TEST(ShortNumbers, normals_areAsLongAsWholeNumbersSay) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Scene renewed = withShortNumbers(distanceScene(), seed);
    const ExactVec3 &n = coordinate(*findObject(renewed, "E"), 1);
    EXPECT_TRUE(Surd::root(dot(n, n)).isRational()) << textOf(renewed);
  }
}

TEST(ShortNumbers, objectsThatNoConstructionLooksAt_getSomeToo) {
  Scene scene = distanceScene();
  scene.entries.insert(0, rayL());
  scene.entries.insert(0, triangleT());
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Scene renewed = withShortNumbers(scene, seed);
    EXPECT_EQ(lastCase(renewed), "positive");
    EXPECT_FALSE(shareAnObject(renewed, scene)) << textOf(renewed);
    expectShort(renewed);
  }
}

TEST(ShortNumbers, whatIsLocked_staysAsItIs) {
  Scene scene = distanceScene();
  scene.entries.change(*scene.entries.placeOf("Q"), [](Entry &entry) { entry.isLocked = true; });
  const Scene renewed = withShortNumbers(scene, 3);
  EXPECT_EQ(*findObject(renewed, "Q"), *findObject(scene, "Q"));
  EXPECT_NE(*findObject(renewed, "E"), *findObject(scene, "E"));
}

TEST(ShortNumbers, sceneWithoutConstruction_getsSome) {
  const Scene scene{{planeE(), pointQ()}};
  const Scene renewed = withShortNumbers(scene, 1);
  EXPECT_FALSE(shareAnObject(renewed, scene));
  expectShort(renewed);
}

TEST(ShortNumbers, objectsThatNoConstructionLooksAt_haveNoSayInItsNumbers) {
  Scene scene = distanceScene();
  for (int i = 0; i < 1000; ++i) {
    Entry more = triangleT();
    more.name = "T" + std::to_string(i);
    scene.entries.insert(0, std::move(more));
  }
  const Scene renewed = withShortNumbers(scene, 1);
  const Scene alone = withShortNumbers(distanceScene(), 1);
  for (const char *name : {"E", "Q"})
    EXPECT_EQ(*findObject(renewed, name), *findObject(alone, name)) << name;
  EXPECT_FALSE(shareAnObject(renewed, scene));
  expectShort(renewed);
}

} // namespace halfspace
