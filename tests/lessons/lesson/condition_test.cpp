#include "lessons/lesson/condition.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

/// An outcome with a value of every shape.
Evaluation outcome() {
  return test::withValues({{"t", "", Surd(Rational(-10, 3))},
                           {"distance", "", Surd::root(2)},
                           {"foot", "", std::vector<Surd>{1, 2, 0}},
                           {"side", "", Word{"positive", "positive"}},
                           {"feature", "", 2},
                           {"perp", "", std::vector<NamedValue>{{"uu", "", Surd(80)}}}},
                          "hit");
}

bool holdsFor(const std::string &text) {
  const auto conditions = parseConditions(text);
  EXPECT_TRUE(conditions) << text;
  return conditions && isDone(Task{"", *conditions}, outcome());
}

TEST(Condition, OfNumbers_ComparesExactly) {
  EXPECT_TRUE(holdsFor("t = -10/3"));
  EXPECT_FALSE(holdsFor("t = -3.3333333333333333333333"));
  EXPECT_TRUE(holdsFor("t < -3.3333333333333333333333"));
  EXPECT_TRUE(holdsFor("t != 0 and t <= -10/3 and t >= -10/3"));
  EXPECT_FALSE(holdsFor("t > 0"));
}

TEST(Condition, WrittenAsText_IsReadBack) {
  const std::string text =
      "t = -10/3 and s != 0.5 and perp.uu < 3 and a <= 1 and b >= 2 and c > 3 and side = on";
  EXPECT_EQ(toText(*parseConditions(text)), text);
  EXPECT_EQ(toText(*parseConditions("t<0 and  s!=1")), "t < 0 and s != 1");
}

TEST(Condition, OfARoot_ComparesExactly) {
  EXPECT_TRUE(holdsFor("distance > 1.41421356237309504880168872420969807"));
  EXPECT_TRUE(holdsFor("distance < 1.41421356237309504880168872420969808"));
  EXPECT_FALSE(holdsFor("distance = 1.4142135623730951"));
}

TEST(Condition, OfWordsAndTheCase_ComparesTheWord) {
  EXPECT_TRUE(holdsFor("side = positive and case = hit"));
  EXPECT_TRUE(holdsFor("side != negative"));
  EXPECT_FALSE(holdsFor("case = miss"));
}

TEST(Condition, OfPartsAndGroups_FindsTheNumber) {
  EXPECT_TRUE(holdsFor("foot.z = 0 and foot.1 = 2 and perp.uu = 80 and feature = 2"));
  EXPECT_FALSE(holdsFor("foot.3 = 0"));
  EXPECT_FALSE(holdsFor("foot.w = 0"));
  EXPECT_FALSE(holdsFor("perp.none = 0"));
  EXPECT_FALSE(holdsFor("foot = 0"));
  EXPECT_FALSE(holdsFor("perp != 0"));
}

TEST(Condition, OfALongList_FindsTheNumbersBehindTheTenth) {
  const Evaluation twelve =
      test::withValues({{"list", {}, std::vector<Surd>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}}});
  const auto holdsForTwelve = [&](const char *text) { return holds(parseConditions(text)->front(), twelve); };
  EXPECT_TRUE(holdsForTwelve("list.11 = 11") && holdsForTwelve("list.9 = 9"));
  EXPECT_FALSE(holdsForTwelve("list.12 = 12"));
  EXPECT_FALSE(holdsForTwelve("list.01 = 1")) << "that is no index";
}

TEST(Condition, OfAValueThatTheCaseDoesNotHave_NeverHolds) {
  EXPECT_FALSE(holdsFor("s = 0"));
  EXPECT_FALSE(holdsFor("s != 0"));
}

TEST(Condition, OneOfSeveralFalse_IsNotDone) { EXPECT_FALSE(holdsFor("case = hit and t = 1")); }

TEST(Condition, Malformed_IsAProblem) {
  for (const char *text : {"", "t", "t =", "= 1", "t ! 1", "t = 1 and", "t == 1", "side < positive", "t = $x",
                           "t = 1 and and t = 2"})
    EXPECT_FALSE(parseConditions(text)) << text;
}

} // namespace
} // namespace halfspace
