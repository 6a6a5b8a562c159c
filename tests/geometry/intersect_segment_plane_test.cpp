// Segments across planes, beside them and in them.
#include "geometry/intersect_segment_plane.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

const Plane<Rational> floorTwice{{0, 0, 2}, -2}; // z = 1, with a normal that is not of length 1

SegmentPlane<Rational> met(const ExactVec3 &from, const ExactVec3 &to) {
  return intersectSegmentPlane(from, to, floorTwice);
}

TEST(IntersectSegmentPlane, ThroughThePlane_MeetsItAtTheRatioOfItsHeights) {
  const auto meet = met({0, 0, 0}, {6, 3, 3});
  EXPECT_EQ(meet.which, SegmentPlaneCase::Crosses);
  EXPECT_EQ(meet.atFrom, -2);
  EXPECT_EQ(meet.atTo, 4);
  EXPECT_EQ(meet.t, Rational(1, 3));
  EXPECT_EQ(meet.point, ExactVec3(2, 1, 1));
}

TEST(IntersectSegmentPlane, WithAnEndInThePlane_TouchesItThere) {
  EXPECT_EQ(met({5, 4, 1}, {0, 0, 3}).which, SegmentPlaneCase::Touches);
  EXPECT_EQ(met({5, 4, 1}, {0, 0, 3}).point, ExactVec3(5, 4, 1));
  EXPECT_EQ(met({0, 0, 3}, {5, 4, 1}).t, 1);
}

TEST(IntersectSegmentPlane, OnOneSide_TellsWhereItsLineMeetsThePlane) {
  const auto meet = met({0, 0, 2}, {1, 0, 3});
  EXPECT_EQ(meet.which, SegmentPlaneCase::Beside);
  EXPECT_EQ(meet.t, -1);
  EXPECT_EQ(meet.point, ExactVec3(-1, 0, 1));
}

TEST(IntersectSegmentPlane, AlongThePlaneOrWithoutLengthOrNormal_IsACaseOfItsOwn) {
  EXPECT_EQ(met({0, 0, 2}, {1, 1, 2}).which, SegmentPlaneCase::Parallel);
  EXPECT_EQ(met({0, 0, 1}, {1, 1, 1}).which, SegmentPlaneCase::InPlane);
  EXPECT_EQ(met({0, 0, 1}, {0, 0, 1}).which, SegmentPlaneCase::ZeroLength);
  const Plane<Rational> none{{0, 0, 0}, 3};
  EXPECT_EQ(intersectSegmentPlane<Rational>({0, 0, 1}, {0, 0, 1}, none).which, SegmentPlaneCase::ZeroNormal);
}

TEST(IntersectSegmentPlane, Any_FollowsTheLaws) {
  RandomNumbers random(313);
  std::map<SegmentPlaneCase, int> cases;
  for (int i = 0; i < test::effort(10'000); ++i) {
    const ExactVec3 from = random.wholeVector(2);
    const ExactVec3 to = random.wholeVector(2);
    const Plane<Rational> plane{random.wholeVector(1), random.integer(-1, 1)};
    const auto meet = intersectSegmentPlane(from, to, plane);
    ++cases[meet.which];
    const bool isMet = meet.which == SegmentPlaneCase::Crosses || meet.which == SegmentPlaneCase::Touches ||
                       meet.which == SegmentPlaneCase::Beside;
    if (isMet) {
      EXPECT_EQ(evaluate(plane, meet.point), 0); // law (1)
      EXPECT_EQ(meet.which == SegmentPlaneCase::Touches, meet.point == from || meet.point == to);
      EXPECT_EQ(meet.which == SegmentPlaneCase::Crosses, meet.t > 0 && meet.t < 1); // law (2)
      EXPECT_EQ(meet.which == SegmentPlaneCase::Beside, meet.t < 0 || meet.t > 1);
    }
    const auto back = intersectSegmentPlane(to, from, plane); // law (3)
    EXPECT_EQ(back.which, meet.which);
    EXPECT_EQ(back.point, meet.point);
    if (isMet) {
      EXPECT_EQ(back.t, 1 - meet.t);
    }
    const Rational k = random.nonZeroRational();
    const auto scaled =
        intersectSegmentPlane<Rational>(from, to, {plane.normal * k, Rational(plane.offset * k)}); // law (4)
    EXPECT_EQ(scaled.which, meet.which);
    EXPECT_EQ(scaled.atFrom, meet.atFrom * k);
    EXPECT_EQ(scaled.atTo, meet.atTo * k);
    EXPECT_EQ(scaled.point, meet.point);
  }
  if (!test::isWatched) {
    EXPECT_EQ(cases.size(), 7U) << "a case did not come up";
  }
}

} // namespace
} // namespace halfspace
