// What a tool takes under a pixel: points that are seen, and new ones.
#include "widgets/picture/hand/tool_pick.h"

#include "tests/lessons/scenes.h"
#include "tests/picture/hand/tool_scenes.h"
#include "widgets/picture/hand/handle_drag.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

View viewOf(const Place &target, double elevation = 0.6) {
  View view;
  view.camera.target = target;
  view.camera.azimuth = 0.7;
  view.camera.elevation = elevation;
  view.size = {1280, 800};
  return view;
}

/// A scene as it is seen, pointed at by a tool.
struct Pointing {
  Scene scene;
  ObjectTool tool;
  View view = viewOf({0, 0, 0});
  Rational step = 1;
  Evaluation evaluation = evaluate(scene);
  Stage stage = stageOf(PlacedScene(scene, evaluation));
  Figure figure = toStage(figureOf(evaluation), stage);

  [[nodiscard]] ToolScene seen() const { return {evaluation, figure, stage, step}; }
  [[nodiscard]] ToolRoom room() const { return roomFor(*wishOf(tool), stage); }
  /// What is taken at the pixel where a place of the stage is seen.
  [[nodiscard]] std::optional<ToolPick> at(const Place &place) const {
    const glm::dvec2 pixel(view.camera.project(place, view.size).value());
    return pickUnder(pixel, tool, seen(), room(), view);
  }
};

std::string lineAt(const Pointing &pointing, const Place &place) {
  const auto pick = pointing.at(place);
  return !pick ? "nothing" : pick->entry ? lineFor(*pick->entry) : pick->name;
}

TEST(ToolPick, AtAnEmptyPlace_IsANewPointOfTheGridOnTheGround) {
  const Pointing pointing{typedScene({"A = (5, 5, 5)"}), {ToolObject::Segment}};
  EXPECT_EQ(lineAt(pointing, {2.2, 2.9, 0}), "B = (2, 3, 0)");
  Pointing fine = pointing;
  fine.step = q(1, 2);
  EXPECT_EQ(lineAt(fine, {2.3, 2.9, 0}), "B = (5/2, 3, 0)");
}

TEST(ToolPick, AtAPointThatIsSeen_IsThat) {
  const Pointing pointing{typedScene({"A = (5, 5, 5)", "T = triangle((1, 0, 4), (0, 5, 0), (0, 0, 5))",
                                      "E: z = 2", "d = signed-distance(E, A)"}),
                          {ToolObject::Segment}};
  EXPECT_EQ(lineAt(pointing, {5, 5, 5}), "A");
  EXPECT_EQ(lineAt(pointing, {1, 0, 4}), "T.P0");
  EXPECT_EQ(lineAt(pointing, {5, 5, 2}), "d.F");
  EXPECT_EQ(pointing.at({5, 5, 2})->at, ExactVec3(5, 5, 2));
}

TEST(ToolPick, AtAPointThatTheToolHas_IsNothing_ButTheFirstCornerThatCloses) {
  const Scene scene = typedScene({"A = (0, 0, 0)"});
  const Pointing two{scene, withNewPoints({ToolObject::Triangle}, scene, {{3, 0, 0}})};
  EXPECT_EQ(lineAt(two, {3, 0, 0}), "nothing");
  const Pointing corners{scene,
                         withNewPoints({ToolObject::Polygon}, scene, {{3, 0, 0}, {6, 3, 0}, {3, 6, 0}})};
  EXPECT_EQ(lineAt(corners, {3, 0, 0}), "B = (3, 0, 0)");
  EXPECT_EQ(lineAt(corners, {6, 3, 0}), "nothing");
}

TEST(ToolPick, OnTheGridWhereAPointIs_IsThatPoint) {
  Pointing coarse{typedScene({"A = (5, 5, 0)"}), {ToolObject::Segment}};
  coarse.step = 5;
  EXPECT_EQ(lineAt(coarse, {3.5, 6.4, 0}), "A");
}

TEST(ToolPick, OfAHeight_IsAboveOrBelowTheFirstCorner) {
  const Pointing pointing{Scene(),
                          withNewPoints({ToolObject::Tetrahedron}, {}, {{1, 0, 0}, {4, 0, 0}, {1, 5, 0}})};
  EXPECT_EQ(lineAt(pointing, {1, 0, 3.8}), "D = (1, 0, 4)");
  EXPECT_EQ(lineAt(pointing, {1, 0, -2.2}), "D = (1, 0, -2)");
  EXPECT_EQ(lineAt(pointing, {1, 0, 0}), "nothing") << "there the tool has its first corner";
}

TEST(ToolPick, OfARadius_IsTheDistanceFromTheCentreOnTheGrid) {
  const Scene scene = typedScene({"A = (1, 1, 2)"});
  ObjectTool tool = withPick({ToolObject::Sphere}, {"A", {1, 1, 2}});
  const Pointing pointing{scene, tool};
  EXPECT_EQ(lineAt(pointing, {4.1, 5.1, 2}), "k = 5, 0 <= k <= 10, step 1/10");
  EXPECT_EQ(pointing.at({4.1, 5.1, 2})->at, ExactVec3(6, 1, 2));
  EXPECT_EQ(lineAt(pointing, {1.1, 1, 2}), "k = 1, 0 <= k <= 10, step 1/10") << "no sphere is a point";
}

TEST(ToolPick, OnObjects_IsAPointThatKeepsToThem) {
  const Pointing pointing{
      typedScene({"E: z = 2", "g = (0, 8, 5) + t(1, 0, 0)", "r = ray((0, -8, 5), (1, 0, 0))",
                  "S = sphere((20, 0, 6), 2)", "T = triangle((-9, 0, 6), (-9, 8, 6), (-1, 0, 6))"}),
      {ToolObject::PointOn}};
  EXPECT_EQ(lineAt(pointing, {2.1, 2.9, 2}), "A = point-on-plane(E, (2, 3, 2))");
  EXPECT_EQ(lineAt(pointing, {3.2, 8, 5}), "A = point-on-line(g, 3)");
  EXPECT_EQ(lineAt(pointing, {2.1, -8, 5}), "A = point-on-ray(r, 2)");
  EXPECT_EQ(lineAt(pointing, {-7, 2, 6}), "A = point-on-triangle(T, 1/4, 1/4)");
  EXPECT_EQ(lineAt(pointing, {20, 0, 8}), "A = point-on-sphere(S, 0, 0)") << "its highest place";
}

TEST(ToolPick, OnAnObjectThatFollowsOthers_KeepsToThatToo) {
  const Pointing pointing{
      typedScene({"A = (0, 0, 2)", "E = plane(A, (0, 0, 1))", "Q = (3, 3, 8)", "d = signed-distance(E, Q)"}),
      {ToolObject::PointOn}};
  EXPECT_EQ(lineAt(pointing, {-4, 1, 2}), "B = point-on-plane(E, (-4, 1, 2))");
}

TEST(ToolPick, OfAPointOnAnObject_WhereThereIsNone_IsNothing) {
  const Pointing pointing{typedScene({"A = (5, 5, 5)"}), {ToolObject::PointOn}};
  EXPECT_EQ(lineAt(pointing, {2, 2, 0}), "nothing");
}

TEST(ToolPick, WhereTheGroundIsSeenEdgeOn_IsNothing) {
  Pointing pointing{Scene(), {ToolObject::Point}};
  EXPECT_NE(lineAt(pointing, {1, 1, 0}), "nothing");
  pointing.view = viewOf({0, 0, 0}, 0.05);
  EXPECT_FALSE(canPlace(pointing.room(), pointing.view.camera));
  EXPECT_EQ(lineAt(pointing, {1, 1, 0}), "nothing");
}

TEST(ToolPick, TowardsTheHorizon_StaysWhereObjectsAreDragged) {
  Pointing pointing{Scene(), {ToolObject::Point}};
  pointing.view = viewOf({0, 0, 0}, 0.3);
  const auto pick = pointing.at({-60, -30, 0});
  ASSERT_TRUE(pick);
  EXPECT_EQ(pick->at, ExactVec3(-static_cast<int>(dragBox), -30, 0));
}

TEST(ToolPick, InASceneOfOtherSize_IsOnTheGridOfItsStage) {
  const Pointing pointing{typedScene({"A = (5000, 5000, 5000)"}), {ToolObject::Segment}};
  ASSERT_GT(pointing.stage.exponent, 0);
  const auto pick = pointing.at({2.2, 2.9, 0});
  ASSERT_TRUE(pick);
  EXPECT_EQ(pick->at, ExactVec3(2, 3, 0) * pointing.stage.unit());
}

TEST(ToolPickAt, APlaceOfTheStage_IsThePointThere_OrANewOne) {
  const Scene scene = typedScene({"A = (5, 5, 5)"});
  const Pointing pointing{scene, withNewPoints({ToolObject::Triangle}, scene, {{3, 0, 0}})};
  EXPECT_EQ(pickAt({5, 5, 5}, pointing.tool, pointing.seen())->name, "A");
  EXPECT_EQ(lineFor(*pickAt({5, 5, 4}, pointing.tool, pointing.seen())->entry), "C = (5, 5, 4)");
  EXPECT_FALSE(pickAt({3, 0, 0}, pointing.tool, pointing.seen())) << "the tool has it";
}

TEST(ToolPickAt, ACornerThatIsAPoint_IsCalledAsThat_ButAPointThatIsAVectorIsNot) {
  const Pointing corner{
      typedScene({"A = (5, 5, 5), hidden", "B = (0, 9, 0)", "C = (9, 0, 0)", "T = triangle(A, B, C)"}),
      {ToolObject::Segment}};
  EXPECT_EQ(pickAt({5, 5, 5}, corner.tool, corner.seen())->name, "A");
  const Pointing vector{typedScene({"v = (5, 5, 5)", "P = v"}), {ToolObject::Segment}};
  EXPECT_EQ(pickAt({5, 5, 5}, vector.tool, vector.seen())->name, "P");
}

TEST(FollowedTool, GoesOnWithItsPointsWhereTheyAreNow) {
  const Scene scene = typedScene({"A = (5, 5, 5)", "Q = (1, 1, 1)"});
  ObjectTool tool = withPick({ToolObject::Triangle}, {"A", {5, 5, 5}});
  tool = withNewPoints(tool, scene, {{3, 0, 0}});
  const Scene moved = edited(scene, {ChangeObject{"A", PointObject{{7, 5, 5}}}});
  const auto on = followed(tool, evaluate(moved));
  ASSERT_TRUE(on);
  EXPECT_EQ(on->picks[0].at, ExactVec3(7, 5, 5));
  EXPECT_EQ(on->picks[1], tool.picks[1]);
}

TEST(FollowedTool, WhoseNamesDoNotHoldAnyMore_IsNothing) {
  const Scene scene = typedScene({"A = (5, 5, 5)"});
  ObjectTool tool = withPick({ToolObject::Triangle}, {"A", {5, 5, 5}});
  EXPECT_FALSE(followed(tool, evaluate(Scene()))) << "it is gone";
  tool = withNewPoints(tool, scene, {{3, 0, 0}});
  EXPECT_FALSE(followed(tool, evaluate(typedBelow(scene, {"B = (1, 1, 1)"})))) << "the new name is taken";
}

} // namespace
} // namespace halfspace
