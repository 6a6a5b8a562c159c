// Tools that make objects: from what is taken to the entries of the scene.
#include "widgets/picture/hand/object_tool.h"

#include "lessons/scene/offered_objects.h"
#include "lessons/scene/scene_checker.h"
#include "tests/lessons/scenes.h"
#include "tests/picture/hand/tool_scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

/// A point of a scene.
ToolPick pointOf(const Scene &scene, const std::string &name) {
  return {name, placeNamed(evaluate(scene), name).value()};
}

ObjectTool withPointsOf(ObjectTool tool, const Scene &scene, const std::vector<std::string> &names) {
  for (const std::string &name : names)
    tool = withPick(std::move(tool), pointOf(scene, name));
  return tool;
}

Scene after(const Scene &scene, const std::vector<Entry> &entries) {
  Scene next = scene;
  for (const Entry &entry : entries)
    next.entries.push_back(entry);
  return next;
}

/// What a tool makes is what these lines make below the scene.
void expectTyped(const ObjectTool &tool, const Scene &scene, const std::vector<std::string> &lines) {
  EXPECT_FALSE(wishOf(tool));
  const std::vector<Entry> entries = entriesOf(tool, scene);
  const Scene made = after(scene, entries);
  EXPECT_TRUE(made == typedBelow(scene, lines)) << testing::PrintToString(linesOf(entries));
  EXPECT_FALSE(checkScene(made));
}

struct Made {
  ToolObject object;
  std::vector<ExactVec3> places;
  std::vector<std::string> lines; ///< that make the same
};

TEST(ObjectTool, OfNewPoints_MakesWhatOneWouldType) {
  const std::vector<std::string> three{"A = (1, 2, 0)", "B = (4, 2, 0)", "C = (1, 6, 0)"};
  const std::vector<ExactVec3> places{{1, 2, 0}, {4, 2, 0}, {1, 6, 0}};
  const auto withFirst = [&](std::size_t count, const std::string &object) {
    std::vector<std::string> lines(three.begin(), three.begin() + static_cast<std::ptrdiff_t>(count));
    lines.push_back(object);
    return lines;
  };
  const auto firstPlaces = [&](std::size_t count) {
    return std::vector(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(count));
  };
  const std::vector<Made> all{
      {ToolObject::Point, {{1, 2, 0}}, {"A = (1, 2, 0)"}},
      {ToolObject::Segment, firstPlaces(2), withFirst(2, "s = segment(A, B)")},
      {ToolObject::Line, firstPlaces(2), withFirst(2, "g = line(A, B)")},
      {ToolObject::Ray, firstPlaces(2), withFirst(2, "r = ray(A, B)")},
      {ToolObject::Vector, firstPlaces(2), withFirst(2, "u = vector(A, B)")},
      {ToolObject::PlaneThroughPoints, places, withFirst(3, "E = plane(A, B, C)")},
      {ToolObject::PlaneWithNormal, firstPlaces(2), withFirst(2, "E = plane(A, B - A)")},
      {ToolObject::Triangle, places, withFirst(3, "T = triangle(A, B, C)")},
  };
  for (const Made &made : all)
    expectTyped(withNewPoints({made.object}, {}, made.places), {}, made.lines);
}

TEST(ObjectTool, OfATetrahedron_WantsItsFourthCornerAboveTheFirst) {
  const ObjectTool base = withNewPoints({ToolObject::Tetrahedron}, {}, {{1, 0, 0}, {4, 0, 0}, {1, 5, 0}});
  EXPECT_EQ(wishOf(base), (ToolWish{ToolWish::Kind::Above, {1, 0, 0}}));
  expectTyped(
      withNewPoints(base, {}, {{1, 0, 6}}), {},
      {"A = (1, 0, 0)", "B = (4, 0, 0)", "C = (1, 5, 0)", "D = (1, 0, 6)", "T = tetrahedron(A, B, C, D)"});
}

TEST(ObjectTool, OfASphere_MakesItsRadiusANumberThatCanBeChanged) {
  const ObjectTool centre = withNewPoints({ToolObject::Sphere}, {}, {{1, 2, 0}});
  EXPECT_EQ(wishOf(centre), (ToolWish{ToolWish::Kind::Radius, {1, 2, 0}}));
  expectTyped(withPick(centre, newRadius(centre, {}, 3, 1)), {},
              {"A = (1, 2, 0)", "k = 3, 0 <= k <= 10, step 1/10", "S = sphere(A, k)"});
  expectTyped(withPick(centre, newRadius(centre, {}, 25, 10)), {},
              {"A = (1, 2, 0)", "k = 25, 0 <= k <= 100, step 1", "S = sphere(A, k)"});
}

TEST(ObjectTool, OfABox_GoesUpFromTheLowerOfItsPointsInEachCoordinate) {
  const ObjectTool base = withNewPoints({ToolObject::Box}, {}, {{1, 2, 0}, {4, 6, 0}});
  EXPECT_EQ(wishOf(base), (ToolWish{ToolWish::Kind::Above, {4, 6, 0}}));
  expectTyped(
      withNewPoints(base, {}, {{4, 6, 3}}), {},
      {"A = (1, 2, 0)", "B = (4, 6, 0)", "C = (4, 6, 3)", "K = box(A, B.x - A.x, B.y - A.y, C.z - A.z)"});
  expectTyped(withNewPoints({ToolObject::Box}, {}, {{4, 2, 0}, {1, 6, 0}, {1, 6, -3}}), {},
              {"A = (4, 2, 0)", "B = (1, 6, 0)", "C = (1, 6, -3)",
               "K = box((B.x, A.y, C.z), A.x - B.x, B.y - A.y, A.z - C.z)"});
}

TEST(ObjectTool, OfAPolygon_IsClosedByItsFirstCorner) {
  ObjectTool tool = withNewPoints({ToolObject::Polygon}, {}, {{0, 0, 0}, {4, 0, 0}});
  EXPECT_FALSE(canTake(tool, "A")) << "two corners are too few";
  tool = withNewPoints(tool, {}, {{4, 4, 0}, {0, 4, 0}});
  EXPECT_TRUE(canTake(tool, "A"));
  EXPECT_FALSE(canTake(tool, "B"));
  EXPECT_EQ(wishOf(tool), ToolWish());
  expectTyped(
      withPick(tool, tool.picks.front()), {},
      {"A = (0, 0, 0)", "B = (4, 0, 0)", "C = (4, 4, 0)", "D = (0, 4, 0)", "p = polygon(A, B, C, D)"});
}

TEST(ObjectTool, OfAPolygonWithAsManyCornersAsThereCanBe_IsClosedByItself) {
  std::vector<ExactVec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(i, i * i, 0);
  const ObjectTool tool = withNewPoints({ToolObject::Polygon}, {}, corners);
  EXPECT_FALSE(wishOf(tool));
  EXPECT_EQ(linesOf(entriesOf(tool, {})).back(), "p = polygon(A, B, C, D, P, Q, R, P1)");
}

TEST(ObjectTool, OfAPrism_WantsItsTopAboveTheFirstCorner) {
  const ObjectTool open = withNewPoints({ToolObject::Prism}, {}, {{1, 0, 0}, {4, 0, 0}, {1, 5, 0}});
  const ObjectTool closed = withPick(open, open.picks.front());
  EXPECT_EQ(wishOf(closed), (ToolWish{ToolWish::Kind::Above, {1, 0, 0}}));
  expectTyped(
      withNewPoints(closed, {}, {{1, 0, 6}}), {},
      {"A = (1, 0, 0)", "B = (4, 0, 0)", "C = (1, 5, 0)", "D = (1, 0, 6)", "p = prism(A, D - A, B, C)"});
}

TEST(ObjectTool, OfPointsOfTheScene_NamesThem) {
  const Scene scene = typedScene({"A = (1, 2, 0)", "T = triangle((5, 0, 0), (0, 5, 0), (0, 0, 5))",
                                  "E: z = 3", "d = signed-distance(E, A)"});
  expectTyped(withPointsOf({ToolObject::Segment}, scene, {"T.P0", "d.F"}), scene, {"s = segment(T.P0, d.F)"});
  expectTyped(withPointsOf({ToolObject::Line}, scene, {"T.P1", "A"}), scene, {"g = line(T.P1, A - T.P1)"});
  expectTyped(withNewPoints(withPointsOf({ToolObject::Triangle}, scene, {"A", "d.F"}), scene, {{7, 7, 0}}),
              scene, {"B = (7, 7, 0)", "T1 = triangle(A, d.F, B)"});
}

TEST(ObjectTool, TakesNothingTwice) {
  const Scene scene = typedScene({"A = (1, 2, 0)", "B = (4, 2, 0)"});
  const ObjectTool tool = withPointsOf({ToolObject::Triangle}, scene, {"A"});
  EXPECT_FALSE(canTake(tool, "A"));
  EXPECT_TRUE(canTake(tool, "B"));
}

TEST(ObjectTool, OneStepBack_IsAsBefore) {
  const ObjectTool one = withNewPoints({ToolObject::Triangle}, {}, {{1, 2, 0}});
  EXPECT_EQ(withoutLastPick(withNewPoints(one, {}, {{3, 3, 0}})), one);
  EXPECT_EQ(withoutLastPick(one), ObjectTool{ToolObject::Triangle});
  const ObjectTool open = withNewPoints({ToolObject::Prism}, {}, {{1, 0, 0}, {4, 0, 0}, {1, 5, 0}});
  EXPECT_EQ(withoutLastPick(withPick(open, open.picks.front())), open) << "its closing was the last step";
  std::vector<ExactVec3> corners;
  for (int i = 0; i < 7; ++i)
    corners.emplace_back(i, i * i, 0);
  const ObjectTool seven = withNewPoints({ToolObject::Prism}, {}, corners);
  EXPECT_EQ(withoutLastPick(withNewPoints(seven, {}, {{9, 9, 0}})), seven) << "the eighth has closed it";
}

TEST(ObjectTool, WhatItHasMade_FollowsItsPoints) {
  Scene scene =
      after({}, entriesOf(withNewPoints({ToolObject::Box}, {}, {{1, 2, 0}, {4, 6, 0}, {4, 6, 3}}), {}));
  scene = edited(scene, {ChangeObject{"B", PointObject{{5, 8, 0}}}});
  const Evaluation evaluation = evaluate(scene);
  const Object box = findOffered(evaluation, "K")->given->object;
  EXPECT_EQ(box[0], ExactVec3(1, 2, 0));
  EXPECT_EQ(box[1].x, 4);
  EXPECT_EQ(box[2].x, 6);
  EXPECT_EQ(box[3].x, 3);
}

TEST(ObjectTool, Unfinished_HasTheEntriesOfItsPointsAlone) {
  const ObjectTool tool = withNewPoints({ToolObject::Triangle}, {}, {{1, 2, 0}, {3, 3, 0}});
  EXPECT_EQ(linesOf(entriesOf(tool, {})), (std::vector<std::string>{"A = (1, 2, 0)", "B = (3, 3, 0)"}));
}

} // namespace
} // namespace halfspace
