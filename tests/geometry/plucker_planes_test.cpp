// Planes with planes and with lines, by Plücker coordinates.
#include "geometry/intersect_line_plane.h"
#include "geometry/intersect_planes.h"
#include "geometry/intersect_ray_plane.h"
#include "geometry/point_plane.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

TEST(IntersectPlanes, TwoAxisPlanes_MeetInAParallelToTheThirdAxis) {
  const auto meet = intersectPlanes(Plane<Rational>{ExactVec3(1, 0, 0), -2}, {ExactVec3(0, 1, 0), -3});
  EXPECT_EQ(meet.which, PlanePlaneCase::Line);
  EXPECT_EQ(meet.line.direction, ExactVec3(0, 0, 1));
  EXPECT_EQ(meet.line.moment, ExactVec3(3, -2, 0));
  EXPECT_EQ(meet.nearest, ExactVec3(2, 3, 0));
  EXPECT_EQ(meet.cosine, Surd(0));
}

TEST(IntersectPlanes, AnyTwo_MeetInALineThatLiesInBoth) {
  RandomNumbers random(91);
  for (int i = 0; i < test::effort(2000); ++i) {
    const Plane<Rational> a{random.nonZeroVector(), random.rational()};
    const Plane<Rational> b{random.nonZeroVector(), random.rational()};
    const auto meet = intersectPlanes(a, b);
    if (meet.which != PlanePlaneCase::Line) {
      EXPECT_TRUE(isZero(cross(a.normal, b.normal)));
      continue;
    }
    EXPECT_TRUE(isReal(meet.line)); // law (1)
    EXPECT_EQ(meet.line.direction, cross(a.normal, b.normal));
    EXPECT_EQ(dot(meet.nearest, meet.line.direction), 0);
    EXPECT_EQ(cross(meet.nearest, meet.line.direction), meet.line.moment);
    for (const Plane<Rational> &plane : {a, b}) {
      EXPECT_EQ(evaluate(plane, meet.nearest), 0);
      EXPECT_EQ(dot(plane.normal, meet.line.direction), 0);
      EXPECT_EQ(intersectLinePlane(meet.line, plane).which, LinePlaneCase::InPlane);
    }
  }
}

TEST(IntersectPlanes, MultiplesOfANormal_AreParallelOrCoincidentByTheirOffsets) {
  RandomNumbers random(92);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const Rational k = random.nonZeroRational();
    const Plane<Rational> same{plane.normal * k, Rational(plane.offset * k)};
    EXPECT_EQ(intersectPlanes(plane, same).which, PlanePlaneCase::Coincident);
    EXPECT_EQ(intersectPlanes(plane, same).cosine, Surd(k.sign()));
    const Plane<Rational> moved{same.normal, Rational(same.offset + random.nonZeroRational())};
    EXPECT_EQ(intersectPlanes(plane, moved).which, PlanePlaneCase::Parallel);
  }
}

TEST(IntersectPlanes, InTheOtherOrderOrMultiplied_TurnsAndStretchesTheLine) {
  RandomNumbers random(186);
  std::map<PlanePlaneCase, int> cases;
  for (int i = 0; i < 2000; ++i) {
    const Plane<Rational> a{random.wholeVector(1), random.integer(-1, 1)};
    const Plane<Rational> b{random.wholeVector(1), random.integer(-1, 1)};
    const auto meet = intersectPlanes(a, b);
    ++cases[meet.which];
    const auto swapped = intersectPlanes(b, a); // law (2)
    EXPECT_EQ(swapped.which, meet.which);
    EXPECT_EQ(swapped.line.direction, ExactVec3(-meet.line.direction));
    EXPECT_EQ(swapped.line.moment, ExactVec3(-meet.line.moment));
    EXPECT_EQ(swapped.nearest, meet.nearest);
    EXPECT_EQ(swapped.cosine, meet.cosine);
    const Rational k = random.nonZeroRational();
    const auto scaled = intersectPlanes({a.normal * k, Rational(a.offset * k)}, b); // law (3)
    EXPECT_EQ(scaled.which, meet.which);
    EXPECT_EQ(scaled.line.direction, ExactVec3(meet.line.direction * k));
    EXPECT_EQ(scaled.line.moment, ExactVec3(meet.line.moment * k));
    EXPECT_EQ(scaled.nearest, meet.nearest);
    EXPECT_EQ(scaled.cosine, k < 0 ? -meet.cosine : meet.cosine);
    const bool sameNormal =
        meet.which == PlanePlaneCase::Parallel || meet.which == PlanePlaneCase::Coincident;
    EXPECT_EQ(sameNormal, meet.cosine == Surd(1) || meet.cosine == Surd(-1)); // law (4)
  }
  EXPECT_EQ(cases.size(), 4U) << "a case did not come up";
}

TEST(IntersectPlanes, Cosine_IsThatOfTheNormals) {
  const auto cosine = [](const ExactVec3 &a, const ExactVec3 &b) {
    return toText(intersectPlanes(Plane<Rational>{a, 1}, Plane<Rational>{b, 2}).cosine);
  };
  EXPECT_EQ(cosine(ExactVec3(1, 0, 0), ExactVec3(1, 1, 0)), "1/2*sqrt(2)");
  EXPECT_EQ(cosine(ExactVec3(1, 0, 0), ExactVec3(-1, 1, 0)), "-1/2*sqrt(2)");
  EXPECT_EQ(cosine(ExactVec3(1, 2, 2), ExactVec3(2, 3, 6)), "20/21");
  EXPECT_EQ(cosine(ExactVec3(1, 2, 2), ExactVec3(-2, -4, -4)), "-1");
}

TEST(IntersectPlanes, Distance_IsThatOfEachPointOfOneFromTheOther) { // law (5)
  RandomNumbers random(613);
  for (int i = 0; i < test::effort(10'000); ++i) {
    const Plane<Rational> plane{random.nonZeroWholeVector(3), random.integer(-3, 3)};
    const Rational k = random.nonZeroRational(3);
    const ExactVec3 normal = random.integer(0, 3) == 0 ? random.nonZeroWholeVector(3) : plane.normal * k;
    const Plane<Rational> other{normal, random.integer(0, 1) == 0 ? Rational(plane.offset * k) : k};
    const auto meet = intersectPlanes(plane, other);
    if (meet.which != PlanePlaneCase::Parallel) {
      EXPECT_EQ(meet.distance, Surd(0));
      continue;
    }
    EXPECT_EQ(meet.distance, intersectPlanes(other, plane).distance); // law (2)
    const ExactVec3 any = random.wholeVector(5);
    const ExactVec3 onOther = measurePointPlane(any, other).foot;
    const Surd signedDistance = measurePointPlane(onOther, plane).signedDistance;
    EXPECT_EQ(meet.distance, signedDistance.sign() < 0 ? -signedDistance : signedDistance);
    EXPECT_GT(meet.distance, Surd(0));
  }
}

TEST(IntersectPlanes, DistanceOfParallelPlanes_IsExact) {
  const Plane<Rational> plane{ExactVec3(1, 2, 2), -3};
  EXPECT_EQ(intersectPlanes(plane, {ExactVec3(-2, -4, -4), -12}).distance, Surd(3));
  EXPECT_EQ(intersectPlanes(Plane<Rational>{ExactVec3(1, 1, 0), 0}, {ExactVec3(1, 1, 0), -2}).distance,
            Surd::root(2));
}

TEST(IntersectPlanes, ZeroNormal_IsACaseOfItsOwn) {
  const Plane<Rational> plane{ExactVec3(1, 0, 0), 0};
  const Plane<Rational> none{ExactVec3(0, 0, 0), 1};
  EXPECT_EQ(intersectPlanes(plane, none).which, PlanePlaneCase::ZeroNormal);
  EXPECT_EQ(intersectPlanes(none, plane).which, PlanePlaneCase::ZeroNormal);
}

TEST(IntersectPlanes, DoublesOnSmallIntegers_GiveTheSameLine) {
  // Products of integers this small are integers that a double holds.
  RandomNumbers random(93);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Plane<Rational> a{random.nonZeroWholeVector(9), random.integer(-9, 9)};
    const Plane<Rational> b{random.nonZeroWholeVector(9), random.integer(-9, 9)};
    const auto exact = intersectPlanes(a, b);
    const auto rounded = intersectPlanes(Plane<double>{toDouble(a.normal), toDouble(a.offset)},
                                         {toDouble(b.normal), toDouble(b.offset)});
    EXPECT_EQ(rounded.which, exact.which);
    EXPECT_EQ(rounded.line.direction, toDouble(exact.line.direction));
    EXPECT_EQ(rounded.line.moment, toDouble(exact.line.moment));
    EXPECT_DOUBLE_EQ(rounded.cosine, toDouble(exact.cosine));
  }
}

/// A line across the plane, along it, or in it.
Ray<Rational> someRay(const Plane<Rational> &plane, RandomNumbers &random) {
  const ExactVec3 along = cross(plane.normal, random.vector());
  const ExactVec3 onPlane = plane.normal * Rational(-plane.offset / dot(plane.normal, plane.normal));
  switch (random.integer(0, 2)) {
  case 0:
    return {random.vector(), along};
  case 1:
    return {onPlane + cross(plane.normal, random.vector()), along};
  default:
    return {random.vector(), random.nonZeroVector()};
  }
}

TEST(IntersectLinePlane, AnyLine_AgreesWithTheRaysDotProducts) {
  RandomNumbers random(94);
  std::map<LinePlaneCase, int> cases;
  for (int i = 0; i < 3000; ++i) {
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const Ray<Rational> ray = someRay(plane, random);
    if (isZero(ray.direction))
      continue;
    const auto byDots = intersectRayPlane(ray, plane);
    const auto meet = intersectLinePlane(lineOf(ray), plane);
    ++cases[meet.which];
    EXPECT_EQ(meet.weight, byDots.denominator); // law (3)
    EXPECT_EQ(meet.which == LinePlaneCase::Point, byDots.crosses());
    EXPECT_EQ(meet.which == LinePlaneCase::InPlane, byDots.which == RayPlaneCase::InPlane);
    EXPECT_EQ(meet.which == LinePlaneCase::Parallel, byDots.which == RayPlaneCase::Parallel);
    EXPECT_EQ(meet.point, byDots.point);
    EXPECT_EQ(meet.weighted, byDots.crosses() ? ExactVec3(byDots.point * byDots.denominator)
                                              : ExactVec3(ray.direction * byDots.numerator));
    if (meet.which == LinePlaneCase::Point) { // law (1)
      EXPECT_EQ(evaluate(plane, meet.point), 0);
      EXPECT_EQ(cross(meet.point, ray.direction), lineOf(ray).moment);
    }
    const Line<Rational> line = lineOf(ray);
    const Rational k = random.nonZeroRational();
    for (const auto &scaled : // law (2)
         {intersectLinePlane({line.direction * k, line.moment * k}, plane),
          intersectLinePlane(line, {plane.normal * k, Rational(plane.offset * k)})}) {
      EXPECT_EQ(scaled.which, meet.which);
      EXPECT_EQ(scaled.weighted, ExactVec3(meet.weighted * k));
      EXPECT_EQ(scaled.weight, meet.weight * k);
      EXPECT_EQ(scaled.point, meet.point);
    }
  }
  EXPECT_EQ(cases.size(), 3U) << "a case did not come up";
}

TEST(IntersectLinePlane, ZeroNormalOrNoLine_IsACaseOfItsOwn) {
  const Plane<Rational> none{ExactVec3(0, 0, 0), 1};
  const Line<Rational> unreal{ExactVec3(1, 0, 0), ExactVec3(1, 0, 0)};
  const Line<Rational> axis = lineAlong(ExactVec3(0, 0, 0), ExactVec3(1, 0, 0));
  EXPECT_EQ(intersectLinePlane(axis, none).which, LinePlaneCase::ZeroNormal);
  EXPECT_EQ(intersectLinePlane(unreal, none).which, LinePlaneCase::ZeroNormal);
  EXPECT_EQ(intersectLinePlane(unreal, {ExactVec3(1, 0, 0), 1}).which, LinePlaneCase::NotALine);
}

} // namespace
} // namespace halfspace
