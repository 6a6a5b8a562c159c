#include "geometry/intersect_plane_sphere.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

Rational squaredDistance(const ExactVec3 &a, const ExactVec3 &b) {
  const ExactVec3 way = a - b;
  return dot(way, way);
}

TEST(IntersectPlaneSphere, PlaneThreeFromTheCentreOfARadiusOfFive_CutsACircleOfFour) {
  const auto meet = intersectPlaneSphere(planeThrough(ExactVec3(0, 0, 3), ExactVec3(0, 0, 2)),
                                         Sphere<Rational>{ExactVec3(1, 1, 0), 5});
  EXPECT_EQ(meet.which, PlaneSphereCase::Circle);
  EXPECT_EQ(meet.center.foot, ExactVec3(1, 1, 3));
  EXPECT_EQ(meet.circleRadiusSquared, 16);
  EXPECT_EQ(meet.circleRadius, Surd(4));
}

TEST(IntersectPlaneSphere, AnyPlane_HasTheCircleOfItsPointsOnTheSphere) { // laws (1), (2) and (3)
  RandomNumbers random(411);
  std::map<PlaneSphereCase, int> cases;
  for (int i = 0; i < test::effort(6000); ++i) {
    const ExactVec3 point = random.wholeVector(3);
    const ExactVec3 normal = random.wholeVector(2);
    const auto plane = planeThrough(point, normal);
    const Sphere<Rational> sphere{random.wholeVector(3), random.integer(1, 4)};
    const auto meet = intersectPlaneSphere(plane, sphere);
    ++cases[meet.which];
    EXPECT_EQ(meet.which == PlaneSphereCase::ZeroNormal, isZero(normal));
    if (isZero(normal))
      continue;
    EXPECT_EQ(evaluate(plane, meet.center.foot), 0);
    EXPECT_EQ(meet.circleRadiusSquared,
              sphere.radius * sphere.radius - squaredDistance(sphere.center, meet.center.foot));
    EXPECT_EQ(meet.which == PlaneSphereCase::Miss, meet.circleRadiusSquared < 0);
    EXPECT_EQ(meet.which == PlaneSphereCase::Tangent, meet.circleRadiusSquared == 0);
    EXPECT_EQ(meet.which == PlaneSphereCase::GreatCircle,
              meet.circleRadiusSquared == sphere.radius * sphere.radius);
    const ExactVec3 inPlane = point + cross(normal, random.wholeVector(3));
    EXPECT_EQ(squaredDistance(inPlane, sphere.center) == sphere.radius * sphere.radius,
              squaredDistance(inPlane, meet.center.foot) == meet.circleRadiusSquared);
    if (meet.circleRadiusSquared >= 0) {
      EXPECT_EQ(meet.circleRadius.squared(), Surd(meet.circleRadiusSquared));
    }
  }
  EXPECT_EQ(cases.size(), 5U) << "a case did not come up";
}

TEST(IntersectPlaneSphere, MultipleOfThePlane_IsTheSame) { // law (4)
  RandomNumbers random(412);
  for (int i = 0; i < test::effort(1500); ++i) {
    const auto plane = planeThrough(random.wholeVector(3), random.nonZeroWholeVector(2));
    const Sphere<Rational> sphere{random.wholeVector(3), random.integer(1, 4)};
    const Rational k = random.nonZeroRational(3);
    const auto meet = intersectPlaneSphere(plane, sphere);
    const auto other =
        intersectPlaneSphere(Plane<Rational>{plane.normal * k, Rational(plane.offset * k)}, sphere);
    EXPECT_EQ(other.which, meet.which);
    EXPECT_EQ(other.center.foot, meet.center.foot);
    EXPECT_EQ(other.circleRadiusSquared, meet.circleRadiusSquared);
    EXPECT_EQ(other.circleRadius, meet.circleRadius);
  }
}

TEST(IntersectPlaneSphere, TangentMovedByAHair_CutsOrMisses) {
  const Sphere<Rational> sphere{ExactVec3(0, 0, 0), 1};
  for (int k = 0; k <= 60; ++k) {
    const auto at = [&](const Rational &height) {
      return intersectPlaneSphere(planeThrough(ExactVec3(4, 5, height), ExactVec3(0, 0, 1)), sphere).which;
    };
    EXPECT_EQ(at(Rational(1 - powerOfTen(-k) / 2)), PlaneSphereCase::Circle);
    EXPECT_EQ(at(1), PlaneSphereCase::Tangent);
    EXPECT_EQ(at(Rational(1 + powerOfTen(-k))), PlaneSphereCase::Miss);
  }
}

} // namespace
} // namespace halfspace
