#include "lessons/object/handle.h"
#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "widgets/picture/stage.h"

#include "tests/picture/marks.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

Scene sceneOf(std::vector<Object> objects) {
  Scene scene;
  for (Object &object : objects)
    scene.entries.push_back({"O" + std::to_string(scene.entries.size()), std::move(object)});
  return scene;
}

TEST(Stage, WithABoundPoint_HasItsPlaceAndItsHostInItsUnits) {
  Object far = *makeObject("point-on-line");
  far[0].x = 300;
  const Scene scene{{{"E", PlaneObject{{500, 0, 0}, {1, 0, 0}}},
                     {"F", PlaneObject{{0, 500, 0}, {0, 1, 0}}},
                     {"meet", ConstructionUse{"plane-plane", {{"E", "E"}, {"F", "F"}}}},
                     {"P", far, "meet.g"}}};
  const PlacedScene placed(scene);
  const Stage stage = stageOf(placed);
  EXPECT_GT(stage.exponent, 0);
  const PlacedObject bound = toStage(placed, stage).bound.front();
  EXPECT_EQ(bound.point->object[0], toStage({500, 500, 300}, CoordinateRole::Position, stage));
  EXPECT_EQ(placeOn(far, bound.host->object), bound.point->object[0]) << "with the same freedom";
}

TEST(Stage, OfAPointFarOutOnItsLine_ReachesToIt) {
  Object far = *makeObject("point-on-line");
  far[0].x = 1000000;
  const Scene scene{{{"g", LineObject{{0, 0, 0}, {1, 0, 0}}}, {"P", far, "g"}}};
  EXPECT_EQ(stageOf(scene), stageOf(sceneOf({PointObject{{1000000, 0, 0}}})));
}

TEST(Stage, OfASceneOfUsualSize_IsTheScenesOwnSpace) {
  EXPECT_EQ(stageOf(Scene{}), Stage());
  EXPECT_EQ(stageOf(sceneOf({PointObject{}})), Stage());
  EXPECT_EQ(stageOf(sceneOf({PlaneObject{{5, 4, 7}, {1, 2, 2}}, PointObject{{11, 15, 8}}})), Stage());
  EXPECT_EQ(stageOf(sceneOf({PointObject{{-150, 3, 60}}})), Stage());
}

TEST(Stage, OfAnySize_HoldsItsObjectsAndIsNotTooLargeForThem) {
  for (int exponent = -30; exponent <= 7; ++exponent) {
    const ExactVec3 far = ExactVec3(3, -7, 2) * powerOfTen(exponent);
    const Stage stage = stageOf(sceneOf({PointObject{far}, PointObject{far * Rational(-1, 2)}}));
    const ExactVec3 onStage = toStage(far, CoordinateRole::Position, stage);
    EXPECT_LE(abs(onStage.y), Rational(200)) << exponent;
    EXPECT_GE(abs(onStage.y), Rational(1, 5)) << exponent;
    EXPECT_TRUE(stage.hasAxes());
  }
}

TEST(Stage, OfPositions_IsNotChangedByDirectionsOfAnotherSize) {
  EXPECT_EQ(stageOf(sceneOf({PlaneObject{{5, 4, 7}, {100, 200, 900000}}})), Stage());
  EXPECT_EQ(stageOf(sceneOf({PlaneObject{{5, 4, 7}, {0, 0, Rational(1, 1000000)}}})), Stage());
  const Rational tiny(1, 100000);
  EXPECT_LT(stageOf(sceneOf({PlaneObject{{tiny, 0, 0}, {1, 2, 2}}, PointObject{{0, tiny, 0}}})).exponent, -3);
}

TEST(Stage, OfASingleObjectAtTheOrigin_SuitsItsDirection) {
  EXPECT_EQ(stageOf(sceneOf({PlaneObject{{0, 0, 0}, {1, 2, 2}}})), Stage());
  EXPECT_LT(stageOf(sceneOf({PlaneObject{{0, 0, 0}, {0, 0, Rational(1, 1000000)}}})).exponent, -3);
}

TEST(StagedFigure, OfAnotherSize_ShowsTheDirectionOfFreeArrows) {
  ArrowMark normal;
  normal.vector = {0, 0, 3};
  normal.isFree = true;
  for (const int exponent : {-9, 0, 9}) {
    const Figure staged = toStage({{withId(normal, "n")}}, Stage{ExactVec3(0), exponent});
    const auto *arrow = std::get_if<ArrowMark>(findMark(staged, "n"));
    ASSERT_TRUE(arrow);
    const Place shown = shownVector(*arrow);
    EXPECT_TRUE(exponent != 0 || shown == normal.vector);
    EXPECT_GT(shown.z, 1);
    EXPECT_LT(shown.z, 20);
  }
}

TEST(Stage, OfObjectsTogetherFarAway_StandsAmongThemWithoutTheOrigin) {
  const Stage stage =
      stageOf(sceneOf({PointObject{{1000000, 0, 500000}}, PointObject{{1000009, 4, 500003}}}));
  EXPECT_EQ(stage.exponent, 0);
  EXPECT_FALSE(stage.hasAxes());
  EXPECT_FALSE(stage.hasGround());
  EXPECT_EQ(toStage(ExactVec3(1000009, 4, 500003), CoordinateRole::Position, stage), ExactVec3(9, 4, 3));
  const Stage onGround = stageOf(sceneOf({PointObject{{1000000, 0, 5}}, PointObject{{1000009, 4, 3}}}));
  EXPECT_TRUE(onGround.hasGround());
  EXPECT_FALSE(onGround.hasAxes());
}

TEST(Stage, OfASinglePositionFarAway_HasTheOriginToo) {
  const Stage stage = stageOf(sceneOf({PlaneObject{{20000, 4, 7}, {1, 2, 2}}}));
  EXPECT_TRUE(stage.hasAxes());
  EXPECT_LE(toStage(ExactVec3(20000, 0, 0), CoordinateRole::Position, stage).x, Rational(50));
}

TEST(Stage, PutOnAndTakenBack_IsExactlyTheSame) {
  const Stage stage{{1000000, -25, 0}, -3};
  const Object ray = RayObject{{Rational(1, 3), 7, Rational(-10, 7)}, {Rational(2, 9), 0, 5}};
  const Scene staged = toStage(sceneOf({ray}), stage).scene;
  EXPECT_EQ(fromStage(std::get<Object>(staged.entries.front().content), stage), ray);
  EXPECT_EQ(toStage(ExactVec3(1, 0, 0), CoordinateRole::Direction, stage), ExactVec3(1000, 0, 0));
}

TEST(StagedFigure, OfAUsualScene_IsTheSameFigure) {
  Figure figure{{pointAt({1, 2, 3}), segmentBetween({0, 0, 0}, {9, 9, 9}), patchAt({1, 1, 1}, {0, 0, 1})}};
  EXPECT_EQ(toStage(figure, Stage()).marks, figure.marks);
  for (std::size_t place = 0; place < figure.marks.size(); ++place)
    EXPECT_EQ(toStage(figure, Stage()).marks.shared(place), figure.marks.shared(place)) << "shared";
}

TEST(StagedFigure, BeyondReach_IsCutOffOrLeftOut) {
  ArrowMark arrow;
  arrow.vector = {0, 0, 1e109};
  RayMark ray;
  ray.direction = {1, 0, 0};
  ray.meets = Place(1e109, 0, 0);
  const Figure staged =
      toStage({{withId(pointAt({1e20, 0, 0}), "far"), withId(arrow, "arrow"), withId(ray, "ray"),
                withId(segmentBetween({0, 5000, 0}, {9, 5000, 0}), "beside"),
                withId(segmentBetween({-1e9, 0, 0}, {1e9, 0, 0}), "through")}},
              Stage());
  ASSERT_EQ(staged.marks.size(), 3U);
  const auto *shaft = std::get_if<SegmentMark>(findMark(staged, "arrow"));
  ASSERT_TRUE(shaft);
  EXPECT_EQ(shaft->to, Place(0, 0, drawnReach));
  const auto *through = std::get_if<SegmentMark>(findMark(staged, "through"));
  ASSERT_TRUE(through);
  EXPECT_NEAR(through->from.x, -drawnReach, 1e-3); // doubles of 10^9 are no finer
  EXPECT_NEAR(through->to.x, drawnReach, 1e-3);
  const auto *cutRay = std::get_if<RayMark>(findMark(staged, "ray"));
  ASSERT_TRUE(cutRay);
  EXPECT_EQ(cutRay->meets, Place(drawnReach, 0, 0));
}

} // namespace
} // namespace halfspace
