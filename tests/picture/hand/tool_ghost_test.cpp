// What is shown of an object before it is there.
#include "widgets/picture/hand/tool_ghost.h"

#include "tests/lessons/scenes.h"
#include "tests/picture/hand/tool_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

using namespace test;

std::vector<std::string> idsOf(const Figure &figure) {
  std::vector<std::string> ids;
  for (const Mark &mark : figure.marks)
    ids.push_back(baseOf(mark).id);
  return ids;
}

bool isGhost(const Figure &figure) {
  return std::all_of(figure.marks.begin(), figure.marks.end(),
                     [](const Mark &mark) { return baseOf(mark).role == Role::Ghost; });
}

/// The ghost of a tool that has taken new points, and would take another one.
Figure ghostOfNext(const ObjectTool &tool, const Scene &scene, const ExactVec3 &next) {
  return ghostOf(tool, newPoint(tool, scene, next), evaluate(scene), Stage());
}

TEST(ToolGhost, OfATriangleThatWouldBeComplete_IsThatWithItsNewPoints) {
  const Scene scene = typedScene({"A = (1, 1, 5)"});
  const ObjectTool tool =
      withNewPoints(withPick({ToolObject::Triangle}, {"A", {1, 1, 5}}), scene, {{3, 0, 0}});
  const Figure ghost = ghostOfNext(tool, scene, {0, 4, 0});
  EXPECT_TRUE(isGhost(ghost));
  EXPECT_FALSE(findMark(ghost, "A")) << "it is there already";
  const Mark *triangle = findMark(ghost, "T");
  ASSERT_TRUE(triangle);
  EXPECT_EQ(std::get<PolygonMark>(*triangle).corners, (std::vector<Place>{{1, 1, 5}, {3, 0, 0}, {0, 4, 0}}));
  EXPECT_EQ(std::get<PointMark>(*findMark(ghost, "C")).at, Place(0, 4, 0));
}

TEST(ToolGhost, OfAnObject_HasOneLetterForEachPoint) {
  const Scene scene = typedScene({"A = (1, 1, 5)"});
  const ObjectTool tool = withPick({ToolObject::Segment}, {"A", {1, 1, 5}});
  for (const Mark &mark : ghostOfNext(tool, scene, {0, 4, 0}).marks)
    EXPECT_EQ(baseOf(mark).label, baseOf(mark).id == "B" ? "B" : "") << baseOf(mark).id;
}

TEST(ToolGhost, OfATriangleThatWantsMore_IsTheWaySoFar) {
  const ObjectTool tool = withNewPoints({ToolObject::Triangle}, {}, {{3, 0, 0}});
  const Figure ghost = ghostOfNext(tool, {}, {0, 4, 0});
  EXPECT_EQ(idsOf(ghost), (std::vector<std::string>{"A", "B", "tool/way"}));
  EXPECT_TRUE(isGhost(ghost));
  const auto &way = std::get<SegmentMark>(*findMark(ghost, "tool/way"));
  EXPECT_EQ(way.from, Place(3, 0, 0));
  EXPECT_EQ(way.to, Place(0, 4, 0));
}

TEST(ToolGhost, OfAPolygon_IsClosedAsSoonAsItCanBe) {
  const ObjectTool tool = withNewPoints({ToolObject::Polygon}, {}, {{3, 0, 0}, {6, 3, 0}});
  EXPECT_FALSE(findMark(ghostOf(tool, {}, evaluate({}), Stage()), "p"));
  EXPECT_TRUE(findMark(ghostOfNext(tool, {}, {0, 4, 0}), "p"));
}

TEST(ToolGhost, OfAPrismWithoutItsTop_GoesAroundTheBase) {
  const ObjectTool tool = withNewPoints({ToolObject::Prism}, {}, {{3, 0, 0}, {6, 3, 0}});
  const Figure ghost = ghostOfNext(tool, {}, {0, 4, 0});
  EXPECT_EQ(idsOf(ghost), (std::vector<std::string>{"A", "B", "C", "tool/way", "tool/way/1", "tool/way/2"}));
  EXPECT_EQ(std::get<SegmentMark>(*findMark(ghost, "tool/way/2")).to, Place(3, 0, 0));
}

TEST(ToolGhost, OfNothingTaken_IsTheNewPointAlone) {
  EXPECT_EQ(idsOf(ghostOfNext({ToolObject::Segment}, {}, {1, 2, 0})), std::vector<std::string>{"A"});
  EXPECT_EQ(ghostOf({ToolObject::Segment}, {}, evaluate({}), Stage()).marks.size(), 0U);
}

TEST(ToolGhost, OnAStageOfOtherSize_IsInItsUnits) {
  Stage stage;
  stage.exponent = 2;
  const Figure ghost = ghostOf({ToolObject::Point}, newPoint({}, {}, {500, 0, 0}), evaluate({}), stage);
  EXPECT_EQ(std::get<PointMark>(*findMark(ghost, "A")).at, Place(5, 0, 0));
}

} // namespace
} // namespace halfspace
