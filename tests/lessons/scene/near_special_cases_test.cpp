#include "lessons/scene/near_special_cases.h"

#include "lessons/lesson/lesson.h"
#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/sphere.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

Scene rayAndPlane(const ExactVec3 &start, const ExactVec3 &direction) {
  return {{{"E", PlaneObject{{0, 0, 0}, {0, 0, 2}}},
           {"L", RayObject{start, direction}},
           {"meeting", ConstructionUse{"ray-plane-dot", {{"E", "E"}, {"L", "L"}}}}}};
}

std::optional<NearSpecialCase> nearestIn(const Scene &scene, const std::set<std::string> &entries) {
  const auto all = specialCasesNear(scene, evaluate(scene), entries);
  return all.empty() ? std::nullopt : std::optional(all.front());
}

TEST(NearSpecialCases, SeveralNear_IsTheOneWithTheLeastMove) {
  const Scene steep = rayAndPlane({1, 1, 2}, {1, 0, -3});
  const auto start = nearestIn(steep, {"meeting"});
  ASSERT_TRUE(start);
  EXPECT_EQ(start->squareOfWay, Surd(4)) << "the start, down to the plane";
  EXPECT_EQ(start->change.value().value, Object(RayObject{{1, 1, 0}, {1, 0, -3}}));

  const auto turn = nearestIn(rayAndPlane({1, 1, 2}, {1, 0, -1}), {"meeting"});
  ASSERT_TRUE(turn);
  EXPECT_EQ(turn->squareOfWay, Surd(1)) << "the tip of r, up to the level of the start";
  EXPECT_EQ(turn->sentence, "The ray would run parallel to the plane.");
  EXPECT_EQ(turn->change.value().name, "L");
}

TEST(NearSpecialCases, TakenThere_TheCaseIsTheSpecialOne) {
  const Scene scene = rayAndPlane({1, 1, 2}, {1, 0, -1});
  const Scene there = edited(scene, {nearestIn(scene, {"meeting"})->change.value()});
  EXPECT_EQ(lastOutcome(evaluate(there)).told->name, "parallel");
}

TEST(NearSpecialCases, OfAnEntry_AreAllThatItNames_NearestFirst_EachSaidOnce) {
  const Scene scene = rayAndPlane({1, 1, 2}, {1, 0, -1});
  const auto all = specialCasesNear(scene, evaluate(scene), {"meeting"});
  ASSERT_GT(all.size(), 1U);
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_LE(all[i - 1].squareOfWay, all[i].squareOfWay);
    EXPECT_NE(all[i - 1].sentence, all[i].sentence);
    EXPECT_EQ(all[i].entry, "meeting");
  }
}

TEST(NearSpecialCases, OtherEntries_AreNotAsked) {
  EXPECT_FALSE(nearestIn(rayAndPlane({1, 1, 2}, {1, 0, -1}), {}));
  EXPECT_FALSE(nearestIn(rayAndPlane({1, 1, 2}, {1, 0, -1}), {"E", "L"}));
}

/// With roots in its coordinates, the touching ray is nearer than the one through the centre, which has none.
TEST(NearSpecialCases, ThatNoFractionsLeadTo_IsToldAllTheSame_ButNotOffered) {
  const Scene scene{{{"S", SphereObject{{0, 0, 0}, 5}},
                     {"L", RayObject{{2, 2, -9}, {0, 0, 1}}},
                     {"meeting", ConstructionUse{"ray-sphere", {{"S", "S"}, {"L", "L"}}}}}};
  const auto nearest = nearestIn(scene, {"meeting"});
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->sentence, "The ray's line would touch the sphere.");
  EXPECT_EQ(nearest->squareOfWay, Surd::root(8, -10) + Rational(33)) << "(5 − √8)²";
  EXPECT_FALSE(nearest->change);
}

/// Nobody can move what a construction makes.
TEST(NearSpecialCases, OfWhatIsMade_IsNotOffered) {
  Scene scene = rayAndPlane({1, 1, 2}, {1, 0, -1});
  scene.entries.push_back({"F", PlaneObject{{0, 0, 7}, {0, 1, 1}}});
  scene.entries.push_back({"d", ConstructionUse{"signed-distance", {{"E", "F"}, {"Q", "meeting.H"}}}});
  EXPECT_FALSE(nearestIn(scene, {"d"}));
}

/// A point that slides in a triangle's plane is brought to its nearest edge, by its freedoms.
TEST(NearSpecialCases, OfAPointThatLiesOnAnother_KeepsItThere) {
  Entry point{"Q", *makeObject("point-on-triangle-plane"), "T"};
  std::get<Object>(point.content)[0].x = Rational(1, 4);
  std::get<Object>(point.content)[1].x = Rational(1, 8);
  const Scene scene{{{"T", TriangleObject{{0, 0, 0}, {8, 0, 0}, {0, 8, 0}}},
                     point,
                     {"weights", ConstructionUse{"barycentric", {{"T", "T"}, {"Q", "Q"}}}}}};
  const auto nearest = nearestIn(scene, {"weights"});
  ASSERT_TRUE(nearest);
  EXPECT_EQ(nearest->change.value().name, "Q");
  EXPECT_EQ(nearest->squareOfWay, Surd(1));
  EXPECT_EQ(lastOutcome(evaluate(edited(scene, {nearest->change.value()}))).told->name, "edge");
}

/// The foot would have longer numbers than a coordinate may have.
TEST(NearSpecialCases, BeyondTheLimitsOfCoordinates_IsNotOffered) {
  const Rational thin = *parseRational("1/1234567890123456789012345678901234567");
  const Scene scene{{{"E", PlaneObject{{0, 0, 0}, {1, 2, thin}}},
                     {"Q", PointObject{{3, 5, 7}}},
                     {"d", ConstructionUse{"signed-distance", {{"E", "E"}, {"Q", "Q"}}}}}};
  EXPECT_FALSE(nearestIn(scene, {"d"}));
}

} // namespace
} // namespace halfspace
