#include "lessons/construction/construction.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

#include <set>

namespace halfspace {
namespace {

using namespace test;

TEST(Apply, AnEditOfTheSameKind_ChangesOnlyThatObject) {
  const Session before{"signed-distance", 1, distanceScene()};
  const Session after = apply(before, {"Q", PointObject{{1, 2, 3}}});
  EXPECT_EQ(*findObject(after.scene, "Q"), Object(PointObject{{1, 2, 3}}));
  EXPECT_EQ(*findObject(after.scene, "E"), *findObject(before.scene, "E"));
  EXPECT_EQ(after.step, 1);
}

TEST(Apply, AnEditOfAnotherKindOrOfNoObject_ChangesNothing) {
  const Session before{"signed-distance", 0, distanceScene()};
  EXPECT_EQ(apply(before, {"Q", PlaneObject{}}), before);
  EXPECT_EQ(apply(before, {"X", PointObject{}}), before);
  EXPECT_EQ(apply(before, {"distance", PointObject{}}), before);
}

TEST(Evaluate, TheStartOfTheDistanceLesson_IsTenAwayOnThePositiveSide) {
  const Outcome outcome = evaluate(distanceScene());
  EXPECT_EQ(outcome.caseName, "positive");
  ASSERT_FALSE(outcome.values.empty());
  EXPECT_EQ(std::get<Surd>(outcome.values[0].value), Surd(30));
  EXPECT_EQ(std::get<Surd>(outcome.values[1].value), Surd(10));
  EXPECT_FALSE(outcome.working.lines.empty());
}

TEST(Evaluate, APlanesLabel_HasItsEquationAsOneGroup) {
  const Outcome outcome =
      evaluate(apply({"", 0, distanceScene()}, {"E", PlaneObject{{5, 4, 7}, {-6, 6, 2}}}).scene);
  const Mark *plane = findMark(outcome.figure, "E");
  ASSERT_NE(plane, nullptr);
  const std::string label = baseOf(*plane).label + baseOf(*plane).numbers;
  EXPECT_TRUE(label.starts_with("E\\colon\\ {-6x") && label.ends_with("}")) << label; // a sign, no difference
}

TEST(Evaluate, AnObjectThatNoConstructionLooksAt_IsDrawnAllTheSame) {
  Scene scene = distanceScene();
  scene.entries.push_back({"F", PointObject{{1, 2, 3}}});
  scene.entries.push_back(triangleT());
  const Outcome outcome = evaluate(scene);
  const Mark *point = findMark(outcome.figure, "object:F");
  ASSERT_NE(point, nullptr);
  EXPECT_EQ(std::get<PointMark>(*point).at, Place(1, 2, 3));
  EXPECT_NE(findMark(outcome.figure, "object:T"), nullptr);
  EXPECT_EQ(findMark(outcome.figure, "object:Q"), nullptr) << "the construction draws Q";
}

TEST(Evaluate, DegenerateObjectsThatNothingLooksAt_AreDrawnWithoutWhatTheyLack) {
  const Outcome outcome = evaluate(Scene{{{"E", PlaneObject{{1, 1, 1}, {0, 0, 0}}}, {"L", RayObject{}}}});
  EXPECT_NE(findMark(outcome.figure, "object:E.P0"), nullptr);
  EXPECT_EQ(findMark(outcome.figure, "object:E"), nullptr);
  EXPECT_EQ(findMark(outcome.figure, "object:L.r"), nullptr);
}

TEST(Evaluate, TwoConstructions_GivesTheLastOnesValuesAndAllMarksOnce) {
  Scene scene = distanceScene();
  scene.entries.push_back({"S", PointObject{{0, 0, 0}}});
  scene.entries.push_back({"second", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "S"}}}});
  const Outcome outcome = evaluate(scene);
  EXPECT_EQ(outcome.caseName, "negative");
  EXPECT_NE(findMark(outcome.figure, "distance.Q"), nullptr);
  std::set<std::string> ids;
  for (const Mark &mark : outcome.figure.marks)
    EXPECT_TRUE(ids.insert(baseOf(mark).id).second) << baseOf(mark).id << " stands twice";
}

TEST(Evaluate, TwoConstructionsOverTheSameObjects_DrawsTheGivensOnce) {
  Scene scene = distanceScene();
  scene.entries.push_back({"again", ConstructionUse{"plane-implicit", {{"E", "E"}}}});
  const Outcome outcome = evaluate(scene);
  EXPECT_EQ(findMark(outcome.figure, "distance.n"), nullptr) << "n is drawn already";
  EXPECT_NE(findMark(outcome.figure, "distance.F"), nullptr);
}

TEST(Evaluate, ASceneThatNoReaderWouldPass_IsEvaluatedAsFarAsItGoes) {
  const Scene scene{{pointQ(),
                     {"a", ConstructionUse{"no-such", {}}},
                     {"b", ConstructionUse{"signed-distance", {{"E", "Q"}, {"Q", "Q"}}}},
                     {"c", ConstructionUse{"signed-distance", {}}}}};
  EXPECT_EQ(evaluate(scene).caseName, "");
}

TEST(RefuseCoordinate, AtTheLimits_TakesWhatIsWithinAndSaysWhyNotBeyond) {
  EXPECT_FALSE(refuseCoordinate(coordinateLimit));
  EXPECT_FALSE(refuseCoordinate(Rational(1, mp::pow(Integer(10), 39))));
  EXPECT_TRUE(refuseCoordinate(Rational(coordinateLimit + 1))->find("too large") != std::string::npos);
  EXPECT_TRUE(refuseCoordinate(Rational(-coordinateLimit - 1)));
  EXPECT_TRUE(refuseCoordinate(Rational(1, mp::pow(Integer(10), 40)))->find("too long") != std::string::npos);
}

TEST(FindConstruction, OfAnUnknownId_FindsNone) {
  EXPECT_EQ(findConstruction("no-such"), nullptr);
  ASSERT_NE(findConstruction("ray-plane-dot"), nullptr);
  EXPECT_EQ(findConstruction("ray-plane-dot")->id, "ray-plane-dot");
}

} // namespace
} // namespace halfspace
