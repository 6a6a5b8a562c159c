#include "tests/lessons/scenes.h"

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/live_values.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

std::string filled(const std::string &markdown) {
  const Scene scene = test::distanceScene();
  return withLiveValues(markdown, scene, evaluate(scene));
}

TEST(LiveValues, OfNumbersVectorsAndWords_StandInThePlaceOfTheirNames) {
  EXPECT_EQ(filled("f is {f}."), "f is $30$.");
  EXPECT_EQ(filled("{side}: {case}"), "positive: positive");
  EXPECT_EQ(filled("{foot.z}"), "$4/3$");
}

TEST(LiveValues, OfCoordinates_GoByShortAndFullNames) {
  EXPECT_EQ(filled("{Q} {E.n} {n}"),
            "$\\left(11,\\,15,\\,8\\right)$ $\\left(1,\\,2,\\,2\\right)$ $\\left(1,\\,2,\\,2\\right)$");
}

TEST(LiveValues, OfBoundPoints_AreTheirFreedomsAndTheirPlace) {
  Object half = *makeObject("point-on-line");
  half[0].x = Rational(1, 2);
  const Scene scene{{{"g", LineObject{{1, 0, 0}, {4, 0, 2}}}, {"P", half, "g"}}};
  const auto shown = [&](const std::string &markdown) {
    return withLiveValues(markdown, scene, evaluate(scene));
  };
  EXPECT_EQ(shown("{lambda} {P.lambda}"), "$1/2$ $1/2$");
  EXPECT_EQ(shown("{P.at} {at.x}"), "$\\left(3,\\,0,\\,1\\right)$ $3$");
  EXPECT_EQ(shown("{P.case} {g.case}"), "— —") << "objects have no case";
}

TEST(LiveValues, InFormulasAndCode_AreLeftAlone) {
  for (const char *text : {"$\\frac{f}{2}$", "$$\\frac{f}{2}$$", "`{f}`", "``a ` {f}``", "\\{f}"})
    EXPECT_EQ(filled(text), text);
  EXPECT_EQ(filled("$x${f}$y$"), "$x$$30$$y$");
}

TEST(LiveValues, WithoutAValueInThisCase_AreADash) { EXPECT_EQ(filled("{t} {perp.uu}"), "— —"); }

TEST(LiveValues, WhileTheLearnerLooksForThem_AreQuestionMarks_AndTheSceneIsAsItStands) {
  const Scene scene = test::distanceScene();
  EXPECT_EQ(withLiveValues("f is {f}, {side}: {Q}, {t}", scene, evaluate(scene), LiveValues::Hidden),
            "f is ?, ?: $\\left(11,\\,15,\\,8\\right)$, —");
}

TEST(LiveValues, BracesThatHoldNoName_Stay) { EXPECT_EQ(filled("{1} {} {a b} {"), "{1} {} {a b} {"); }

TEST(LiveValues, WhenRounded_SaySo) {
  const Evaluation outcome = test::withValues({{"x", "", Surd(Rational(1234567890123, 9876543210987))}});
  EXPECT_EQ(withLiveValues("{x}", Scene{}, outcome).substr(0, 9), "$\\approx ");
}

TEST(LiveValues, OfRoots_SayHowLargeTheyAre) {
  const Evaluation outcome = test::withValues({{"x", "", Surd::root(6, 3)}});
  EXPECT_EQ(withLiveValues("It is {x}.", Scene{}, outcome), "It is $3\\sqrt{6}\\approx 7.348$.");
}

} // namespace
} // namespace halfspace
