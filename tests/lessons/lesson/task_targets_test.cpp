// The numbers that tasks ask for, as places of the hand.
#include "lessons/lesson/task_targets.h"

#include "lessons/lesson/condition.h"
#include "lessons/object/kinds/vector.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

std::vector<SnapTarget> targetsFor(const std::string &when, const Scene &scene, const std::string &id) {
  Task task;
  task.conditions = *parseConditions(when);
  return taskTargets({task}, scene, handle(scene, id));
}

Scene withPlane(const PlaneObject &plane) {
  Scene scene = distanceScene();
  setObject(scene, "E", plane);
  return scene;
}

TEST(TaskTargets, OfADistance_AreAllPlacesThatHaveIt) {
  const auto targets = targetsFor("signed_distance = 5", distanceScene(), "Q");
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_EQ(targets[0].name, "dist = 5");
  EXPECT_EQ(targets[0].places.dimension(), 2U);
  const ExactVec3 there(5 + 15, 4, 7); // f = 15 and |n| = 3
  EXPECT_TRUE(targets[0].places.contains(there) && targets[0].counts(there));
  EXPECT_TRUE(targets[0].places.contains({5, 4, 7 + q(15, 2)}));
  EXPECT_FALSE(targets[0].places.contains({5, 4, 7}));
}

TEST(TaskTargets, OfAFootOnTheGround_FollowTheNormal) {
  const auto targets = targetsFor("foot.z = 0 and side != on", distanceScene(), "Q");
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_TRUE(targets[0].places.contains(ExactVec3(27, 0, 0) + ExactVec3(1, 2, 2) * q(3)));
}

TEST(TaskTargets, OfANumberWithARoot_AreOnlyWhereItCanBe) {
  const Scene scene = withPlane({{0, 0, 0}, {1, 1, 1}}); // |n| = √3
  const auto zero = targetsFor("signed_distance = 0", scene, "Q");
  ASSERT_EQ(zero.size(), 1U);
  EXPECT_TRUE(zero[0].places.contains({1, 1, -2}));
  EXPECT_TRUE(targetsFor("signed_distance = 5", scene, "Q").empty()) << "no fraction has that distance";
}

TEST(TaskTargets, OfANumberThatDoesNotGoInProportion_AreNone) {
  EXPECT_TRUE(targetsFor("cos_angle = 0", distanceScene(), "Q").empty());
  EXPECT_TRUE(targetsFor("signed_distance = 5", distanceScene(), "E.n").empty());
}

/// D = 4 w_z, so that the volume of the tetrahedron changes its course one step below the start.
Scene tetrahedronScene() {
  return {{{"u", VectorObject{{0, 0, 0}, {2, 0, 0}}},
           {"v", VectorObject{{0, 0, 0}, {0, 2, 0}}},
           {"w", VectorObject{{0, 0, 0}, {3, 1, q(3, 4)}}},
           {"box", ConstructionUse{"determinant", {{"u", "u"}, {"v", "v"}, {"w", "w"}}}}}};
}

TEST(TaskTargets, OfNoVolume_AreThePlaneOfTheBaseOnce) {
  const auto targets = targetsFor("tetrahedron = 0", tetrahedronScene(), "w.v");
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_TRUE(targets[0].places.contains({-4, 7, 0}) && targets[0].counts({-4, 7, 0}));
}

TEST(TaskTargets, OfAVolume_AreOnBothSidesOfTheBase) {
  const auto targets = targetsFor("tetrahedron = 5 and orientation = left-handed", tetrahedronScene(), "w.v");
  ASSERT_EQ(targets.size(), 2U);
  int below = 0;
  for (const SnapTarget &target : targets) {
    EXPECT_EQ(target.places.dimension(), 2U);
    for (const Rational &height : {q(15, 2), q(-15, 2)})
      if (target.places.contains({-4, 7, height})) {
        EXPECT_TRUE(target.counts({-4, 7, height}));
        below += height < 0 ? 1 : 0;
      }
    EXPECT_FALSE(target.places.contains({-4, 7, 5}));
  }
  EXPECT_EQ(below, 1);
}

TEST(TaskTargets, OfALength_AreOnASphere) {
  const Scene scene{{{"v", VectorObject{{1, 2, 3}, {2, 3, 6}}},
                     {"w", VectorObject{{1, 2, 3}, {1, 0, 0}}},
                     {"shadow", ConstructionUse{"dot-product-projection", {{"v", "v"}, {"w", "w"}}}}}};
  const auto targets = targetsFor("length_v = 7", scene, "v.v");
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_EQ(targets[0].dimension(), 2U);
  EXPECT_EQ(targets[0].name, "|v| = 7");
  EXPECT_EQ(targets[0].surface->at(ExactVec3(1, 2, 3) + ExactVec3(-6, 2, 3)), 0);
  EXPECT_NE(targets[0].surface->at(ExactVec3(1, 2, 3) + ExactVec3(7, 1, 0)), 0);
}

TEST(TaskTargets, OfWordsAndOrders_AreNone) {
  EXPECT_TRUE(targetsFor("side = negative", distanceScene(), "Q").empty());
  EXPECT_TRUE(targetsFor("f < 3", distanceScene(), "Q").empty());
}

TEST(TaskTargets, OfSeveralNumbers_AreWhereAllOfThemAre) {
  const auto targets = targetsFor("foot.z = 0 and signed_distance = 3", distanceScene(), "Q");
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_EQ(targets[0].places.dimension(), 1U);
  EXPECT_TRUE(targets[0].counts(ExactVec3(27, 0, 0) + ExactVec3(1, 2, 2)));
  EXPECT_EQ(targets[0].name, "as the task asks");
}

} // namespace
} // namespace halfspace
