// The planes of all points that are equally far from two planes.
#include "geometry/bisect_planes.h"
#include "geometry/point_plane.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

using ExactPlane = Plane<Rational>;

/// Without its sign.
Surd distanceOf(const ExactVec3 &point, const ExactPlane &plane) {
  const Surd signedDistance = measurePointPlane(point, plane).signedDistance;
  return signedDistance.sign() < 0 ? -signedDistance : signedDistance;
}

bool areSame(const ExactPlane &a, const ExactPlane &b) {
  return intersectPlanes(a, b).which == PlanePlaneCase::Coincident;
}

TEST(BisectPlanes, OfTwoWalls_AreTheDiagonals) {
  const auto bisected = bisectPlanes({{1, 0, 0}, 0}, {{0, 3, 0}, 0});
  EXPECT_EQ(bisected.which, BisectPlanesCase::Crossing);
  EXPECT_EQ(bisected.ratio, Surd(3));
  EXPECT_EQ(bisected.planes[0].normal, ExactVec3(3, 3, 0));
  EXPECT_EQ(bisected.planes[1].normal, ExactVec3(-3, 3, 0));
}

TEST(BisectPlanes, WhoseLengthsHaveARootBetweenThem_AreIrrational) {
  const auto bisected = bisectPlanes({{1, 0, 0}, 0}, {{1, 1, 0}, 0});
  EXPECT_EQ(bisected.which, BisectPlanesCase::Irrational);
  EXPECT_EQ(bisected.ratio, Surd::root(2));
  EXPECT_EQ(bisectPlanes({{1, 1, 0}, 0}, {{0, 1, 1}, 0}).which, BisectPlanesCase::Crossing)
      << "two roots that divide each other away";
}

TEST(BisectPlanes, OfParallelPlanes_IsTheOneHalfway) {
  const auto bisected = bisectPlanes({{0, 0, 1}, 0}, {{0, 0, -2}, 8}); // z = 0 and z = 4
  EXPECT_EQ(bisected.which, BisectPlanesCase::Parallel);
  EXPECT_TRUE(isZero(bisected.planes[0].normal));
  EXPECT_TRUE(areSame(bisected.planes[1], {{0, 0, 1}, -2}));
}

TEST(BisectPlanes, OfTheSamePlaneOrNone_AreCasesOfTheirOwn) {
  EXPECT_EQ(bisectPlanes({{1, 2, 2}, 3}, {{-1, -2, -2}, -3}).which, BisectPlanesCase::Coincident);
  EXPECT_EQ(bisectPlanes({{0, 0, 0}, 3}, {{1, 2, 2}, 3}).which, BisectPlanesCase::ZeroNormal);
  EXPECT_EQ(bisectPlanes({{1, 2, 2}, 3}, {{0, 0, 0}, 0}).which, BisectPlanesCase::ZeroNormal);
}

/// The foot of any point on a plane is a point of it.
void expectEquallyFar(const ExactPlane &bisector, const ExactPlane &a, const ExactPlane &b,
                      const ExactVec3 &any) {
  const ExactVec3 point = measurePointPlane(any, bisector).foot;
  EXPECT_EQ(distanceOf(point, a), distanceOf(point, b));
}

TEST(BisectPlanes, AnyTwo_FollowTheLaws) {
  RandomNumbers random(314);
  std::map<BisectPlanesCase, int> cases;
  for (int i = 0; i < test::effort(10'000); ++i) {
    const ExactPlane a{random.wholeVector(2), random.integer(-2, 2)};
    const ExactPlane b{random.wholeVector(2), random.integer(-2, 2)};
    const auto bisected = bisectPlanes(a, b);
    ++cases[bisected.which];
    if (bisected.which == BisectPlanesCase::ZeroNormal)
      continue;
    const auto &[sum, difference] = bisected.planes;
    const bool isCrossing = intersectPlanes(a, b).which == PlanePlaneCase::Line;
    const Rational squares = dot(a.normal, a.normal) * dot(b.normal, b.normal);
    EXPECT_EQ(bisected.which == BisectPlanesCase::Irrational,
              isCrossing && !Surd::root(squares).isRational()); // law (5)
    if (bisected.which == BisectPlanesCase::Irrational)
      continue;
    const ExactVec3 any = random.wholeVector(5);
    for (const ExactPlane &plane : bisected.planes) // law (1)
      if (!isZero(plane.normal))
        expectEquallyFar(plane, a, b, any);
    if (bisected.which != BisectPlanesCase::Coincident) {
      const bool isOn = evaluate(sum, any) == 0 || evaluate(difference, any) == 0;
      EXPECT_EQ(distanceOf(any, a) == distanceOf(any, b), isOn);
    }
    EXPECT_EQ(dot(sum.normal, difference.normal), 0);                        // law (2)
    EXPECT_EQ(isZero(sum.normal) || isZero(difference.normal), !isCrossing); // law (3)
    const ExactPlane turned{a.normal * Rational(-2), Rational(a.offset * -2)};
    const auto exchanged = bisectPlanes(turned, b); // law (4)
    EXPECT_EQ(exchanged.planes[0].normal, difference.normal);
    EXPECT_EQ(exchanged.planes[1].offset, sum.offset);
  }
  if (!test::isWatched) {
    EXPECT_EQ(cases.size(), 5U) << "a case did not come up";
  }
}

} // namespace
} // namespace halfspace
