// What holds of the drags of every handle of every kind.
#include "lessons/object/coordinate_limits.h"
#include "tests/lessons/object/spelled_objects.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

const std::vector<std::string> draggedKinds{"point",       "vector", "line",     "ray",
                                            "segment",     "plane",  "triangle", "polygon",
                                            "tetrahedron", "prism",  "box",      "sphere"};

struct EveryDraggedKind : testing::TestWithParam<std::string> {
  [[nodiscard]] Scene scene() const { return spelledScene(spelledEntry(GetParam())); }

  /// The scene after one of its handles was dragged by a way; along its own axis where it has one.
  static Scene dragged(const Scene &before, const std::string &id, const ExactVec3 &way) {
    const Handle grabbed = handle(before, id);
    const ExactVec3 to = grabbed.at + (grabbed.hasAxis() ? grabbed.axis * way.x : way);
    return edited(before, {ChangeObject{grabbed.object, movedTo(*findObject(before, "K"), grabbed, to)}});
  }
};

TEST_P(EveryDraggedKind, DraggedThereAndBack_IsAsItWas) {
  const Scene before = scene();
  for (const Handle &each : handlesOf(before)) {
    const Scene there = dragged(before, each.id, {q(1, 3), 2, -1});
    EXPECT_NE(there, before) << each.id;
    EXPECT_EQ(dragged(there, each.id, {q(-1, 3), -2, 1}), before) << each.id;
  }
}

TEST_P(EveryDraggedKind, DraggedTwice_IsAsDraggedOnceByBothWays) {
  const Scene before = scene();
  for (const Handle &each : handlesOf(before)) {
    const Scene twice = dragged(dragged(before, each.id, {1, 2, 3}), each.id, {q(1, 2), -5, 1});
    EXPECT_EQ(twice, dragged(before, each.id, {q(3, 2), -3, 4})) << each.id;
  }
}

TEST_P(EveryDraggedKind, DraggedAsAWhole_KeepsItsShape) {
  const Scene before = scene();
  for (const Handle &each : handlesOf(before)) {
    if (each.motion != Handle::Motion::Whole && each.motion != Handle::Motion::AlongNormal)
      continue;
    const Scene after = dragged(before, each.id, {2, -1, 5});
    const Object &from = *findObject(before, "K");
    const Object &to = *findObject(after, "K");
    const ExactVec3 way = to[0] - from[0];
    EXPECT_FALSE(isZero(way));
    for (std::size_t i = 0; i < from.size(); ++i) {
      const bool isPosition = coordinatesOf(from)[i].role == CoordinateRole::Position;
      EXPECT_EQ(to[i] - from[i], isPosition ? way : ExactVec3(0)) << each.id << " " << i;
    }
  }
}

TEST_P(EveryDraggedKind, WithOneHandleDragged_HasTheOthersWhereTheyBelong) {
  const Scene before = scene();
  for (const Handle &each : handlesOf(before)) {
    const Scene after = dragged(before, each.id, {1, 1, 1});
    for (const Handle &other : handlesOf(after)) {
      const Object &object = *findObject(after, "K");
      if (other.motion == Handle::Motion::Coordinate) {
        EXPECT_EQ(other.at - other.base, object[other.coordinate]) << other.id << " after " << each.id;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EveryDraggedKind, testing::ValuesIn(draggedKinds));

TEST(CoordinateLimits, OfNumerators_AreFortyDigits) {
  const Rational longest = (powerOfTen(40) - 1) / (powerOfTen(39) + 1);
  EXPECT_FALSE(refuseCoordinate(longest));
  const Rational tooLong = (powerOfTen(40) + 1) / (powerOfTen(39) + 1);
  ASSERT_TRUE(refuseCoordinate(tooLong));
  EXPECT_NE(refuseCoordinate(tooLong)->find("40"), std::string::npos) << "it says how many there may be";
}

TEST(CoordinateLimits, OfAnObject_NameTheFirstCoordinateBeyondThem) {
  Object sphere = spelledObject("sphere");
  EXPECT_FALSE(refusedCoordinateOf(sphere));
  sphere[1].x = coordinateLimit + 1;
  EXPECT_EQ(refusedCoordinateOf(sphere)->name, "R");
  sphere[0].z = -coordinateLimit - 1;
  EXPECT_EQ(refusedCoordinateOf(sphere)->name, "c");
}

TEST(CoordinateLimits, OfASingleNumber_AreNotForWhatItHasNot) {
  Object sphere = spelledObject("sphere");
  sphere[1].y = coordinateLimit * 2; // no part of a length
  EXPECT_FALSE(refusedCoordinateOf(sphere));
}

TEST(EndlessNumbers, OfWhatIsMade_AreThoseOfVeryManyDigits) {
  const Rational limit = powerOfTen(madeDigits);
  Object point = spelledObject("point");
  EXPECT_FALSE(hasEndlessNumbers(point));
  point[0].y = limit;
  EXPECT_FALSE(hasEndlessNumbers(point));
  point[0].y = -limit - 1;
  EXPECT_TRUE(hasEndlessNumbers(point));
  point[0].y = 1 / (limit + 1);
  EXPECT_TRUE(hasEndlessNumbers(point));
}

} // namespace
} // namespace halfspace
