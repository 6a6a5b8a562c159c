#include "geometry/intersect_ray_plane.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

const Plane<Rational> notesPlane = planeThrough(ExactVec3(5, 4, 7), ExactVec3(1, 2, 2));
const ExactVec3 notesOrigin(11, 15, 8);

TEST(IntersectRayPlane, NotesExample_IsBehindAtMinusTenThirds) {
  const auto result = intersectRayPlane({notesOrigin, ExactVec3(-1, 3, 2)}, notesPlane);
  EXPECT_EQ(result.which, RayPlaneCase::Behind);
  EXPECT_EQ(result.numerator, -30);
  EXPECT_EQ(result.denominator, 9);
  EXPECT_EQ(result.t, Rational(-10, 3));
  EXPECT_EQ(result.point, ExactVec3(Rational(43, 3), 5, Rational(4, 3)));
  EXPECT_TRUE(result.crosses());
}

TEST(IntersectRayPlane, NotesExampleReversed_HitsAtTenThirds) {
  const auto result = intersectRayPlane({notesOrigin, ExactVec3(1, -3, -2)}, notesPlane);
  EXPECT_EQ(result.which, RayPlaneCase::Hit);
  EXPECT_EQ(result.t, Rational(10, 3));
  const auto facing = facingNormal(notesPlane.normal, ExactVec3(1, -3, -2));
  EXPECT_EQ(toText(facing[0]), "1/3");
  EXPECT_EQ(toText(facing[1]), "2/3");
  EXPECT_EQ(toText(facing[2]), "2/3");
}

TEST(IntersectRayPlane, StartOnThePlane_HitsAtZero) {
  const auto result = intersectRayPlane({ExactVec3(5, 4, 7), ExactVec3(0, 0, 1)}, notesPlane);
  EXPECT_EQ(result.which, RayPlaneCase::Hit);
  EXPECT_EQ(result.t, 0);
}

TEST(IntersectRayPlane, DirectionAlongThePlane_IsParallelOrInThePlane) {
  const ExactVec3 along(2, -1, 0);
  const auto parallel = intersectRayPlane({notesOrigin, along}, notesPlane);
  EXPECT_EQ(parallel.which, RayPlaneCase::Parallel);
  EXPECT_EQ(parallel.numerator, -30);
  EXPECT_EQ(parallel.denominator, 0);
  EXPECT_FALSE(parallel.crosses());
  const auto inPlane = intersectRayPlane({ExactVec3(5, 4, 7), along}, notesPlane);
  EXPECT_EQ(inPlane.which, RayPlaneCase::InPlane);
  EXPECT_FALSE(inPlane.crosses());
}

TEST(IntersectRayPlane, ZeroNormalOrDirection_IsACaseOfItsOwn) {
  const ExactVec3 zero(0, 0, 0);
  EXPECT_EQ(intersectRayPlane({notesOrigin, zero}, notesPlane).which, RayPlaneCase::ZeroDirection);
  EXPECT_EQ(intersectRayPlane({notesOrigin, notesOrigin}, Plane<Rational>{zero, 1}).which,
            RayPlaneCase::ZeroNormal);
  EXPECT_EQ(intersectRayPlane({notesOrigin, zero}, Plane<Rational>{zero, 1}).which, RayPlaneCase::ZeroNormal);
}

TEST(IntersectRayPlane, AnyRay_MeetsThePlaneAtItsPoint) {
  RandomNumbers random(41);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Ray<Rational> ray{random.vector(), random.nonZeroVector()};
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const auto result = intersectRayPlane(ray, plane);
    EXPECT_EQ(result.crosses(), dot(ray.direction, plane.normal) != 0); // law (1)
    if (!result.crosses())
      continue;
    EXPECT_EQ(evaluate(plane, result.point), 0); // law (2)
    EXPECT_EQ(result.point, pointAt(ray, result.t));
    EXPECT_EQ(result.which, result.t < 0 ? RayPlaneCase::Behind : RayPlaneCase::Hit);

    const Rational k = i % 2 == 0 ? Rational(-1) : random.nonZeroRational();
    const auto stretched = intersectRayPlane({ray.origin, ray.direction * k}, plane); // law (3)
    EXPECT_EQ(stretched.t, result.t / k);
    EXPECT_EQ(stretched.point, result.point);
  }
}

TEST(IntersectRayPlane, MultipleOfThePlane_MultipliesTheFractionAndKeepsTheRest) { // law (4)
  RandomNumbers random(185);
  std::map<RayPlaneCase, int> cases;
  for (int i = 0; i < 2000; ++i) {
    const Ray<Rational> ray{random.wholeVector(1), random.wholeVector(1)};
    const Plane<Rational> plane{random.wholeVector(1), random.integer(-1, 1)};
    const Rational k = random.nonZeroRational();
    const auto result = intersectRayPlane(ray, plane);
    const auto scaled = intersectRayPlane(ray, {plane.normal * k, Rational(plane.offset * k)});
    ++cases[result.which];
    EXPECT_EQ(scaled.which, result.which);
    EXPECT_EQ(scaled.numerator, result.numerator * k);
    EXPECT_EQ(scaled.denominator, result.denominator * k);
    EXPECT_EQ(scaled.t, result.t);
    EXPECT_EQ(scaled.point, result.point);
    EXPECT_EQ(result.crosses(), result.denominator != 0); // law (1)
  }
  EXPECT_EQ(cases.size(), 6U) << "a case did not come up";
}

TEST(IntersectRayPlane, FacingNormal_IsUnitAndAgainstTheRayOnWhicheverSideTheNormalPoints) {
  RandomNumbers random(42);
  for (int i = 0; i < test::effort(500); ++i) {
    const Ray<Rational> ray{random.vector(), random.nonZeroVector()};
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const auto result = intersectRayPlane(ray, plane);
    if (!result.crosses())
      continue;
    const auto facing = facingNormal(plane.normal, ray.direction);
    const Rational k = i % 2 == 0 ? Rational(-1) : random.nonZeroRational();
    EXPECT_EQ(facingNormal(ExactVec3(plane.normal * k), ray.direction), facing); // law (3)
    EXPECT_EQ(facingNormal(plane.normal, ExactVec3(ray.direction * abs(k))), facing);
    const std::array<Surd, 3> back{-facing[0], -facing[1], -facing[2]};
    EXPECT_EQ(facingNormal(plane.normal, ExactVec3(-ray.direction)), back);
    const double length = std::hypot(toDouble(facing[0]), toDouble(facing[1]), toDouble(facing[2]));
    EXPECT_DOUBLE_EQ(length, 1);
    // All three share one root, so their signs and ratios are those of ±n: laws (1) and (2).
    const Rational side = result.denominator > 0 ? -1 : 1;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_EQ(facing[static_cast<std::size_t>(axis)],
                overRoot(Rational(plane.normal[axis] * side), dot(plane.normal, plane.normal)));
    EXPECT_LT(Rational(dot(ray.direction, plane.normal) * side), 0);
  }
}

TEST(IntersectRayPlane, RayTurnedTowardsParallel_IsParallelOnlyAtZero) {
  const Plane<Rational> ground{ExactVec3(0, 0, 1), 0};
  for (int k = 0; k <= 60; ++k) {
    const Rational tilt = powerOfTen(-k);
    const auto down = intersectRayPlane({ExactVec3(0, 0, 1), ExactVec3(1, 0, Rational(-tilt))}, ground);
    EXPECT_EQ(down.which, RayPlaneCase::Hit);
    EXPECT_EQ(down.t, powerOfTen(k));
    const auto up = intersectRayPlane({ExactVec3(0, 0, 1), ExactVec3(1, 0, tilt)}, ground);
    EXPECT_EQ(up.which, RayPlaneCase::Behind);
    EXPECT_EQ(up.t, -powerOfTen(k));
  }
  EXPECT_EQ(intersectRayPlane({ExactVec3(0, 0, 1), ExactVec3(1, 0, 0)}, ground).which,
            RayPlaneCase::Parallel);
}

TEST(IntersectRayPlane, Doubles_AgreeWithFractionsWhereTheAngleIsLarge) {
  RandomNumbers random(43);
  // |r·n| ≥ 1 and coordinates up to 20 keep the relative rounding error of t far below this bound.
  const double bound = 1e-8;
  for (int i = 0; i < test::effort(1000); ++i) {
    const Ray<Rational> ray{random.vector(), random.nonZeroVector()};
    const Plane<Rational> plane = planeThrough(random.vector(), random.nonZeroVector());
    const auto exact = intersectRayPlane(ray, plane);
    if (abs(exact.denominator) < 1)
      continue;
    const auto rounded = intersectRayPlane(Ray<double>{toDouble(ray.origin), toDouble(ray.direction)},
                                           Plane<double>{toDouble(plane.normal), toDouble(plane.offset)});
    EXPECT_NEAR(rounded.t, toDouble(exact.t), bound);
    EXPECT_NEAR(facingNormal(toDouble(plane.normal), toDouble(ray.direction))[2],
                toDouble(facingNormal(plane.normal, ray.direction)[2]), bound);
    EXPECT_EQ(rounded.which, exact.which);
  }
}

} // namespace
} // namespace halfspace
