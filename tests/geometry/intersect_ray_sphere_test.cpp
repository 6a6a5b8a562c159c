#include "geometry/intersect_ray_sphere.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace halfspace {
namespace {

using SurdVec3 = std::array<Surd, 3>;

/// A vector whose length is a fraction.
ExactVec3 vectorOfRationalLength(RandomNumbers &random, Rational &length) {
  constexpr std::array<std::array<int, 4>, 6> quadruples{
      {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 6, 9, 11}, {0, 3, 4, 5}}};
  const auto &quadruple = quadruples[static_cast<std::size_t>(random.integer(0, 5))];
  const Rational scale = abs(random.nonZeroRational(3));
  length = scale * quadruple[3];
  ExactVec3 vector;
  const int turn = random.integer(0, 2);
  for (int axis = 0; axis < 3; ++axis) {
    const int sign = random.integer(0, 1) == 0 ? 1 : -1;
    vector[(axis + turn) % 3] = scale * quadruple[static_cast<std::size_t>(axis)] * sign;
  }
  return vector;
}

TEST(IntersectRaySphere, RayThroughTheCenter_MeetsItTwice) {
  const auto meet = intersectRaySphere(Ray<Rational>{ExactVec3(0, 0, 0), ExactVec3(2, 0, 0)},
                                       Sphere<Rational>{ExactVec3(6, 0, 0), 2});
  EXPECT_EQ(meet.which, RaySphereCase::Hit);
  EXPECT_EQ(meet.contacts, SphereContacts::Two);
  EXPECT_EQ(meet.origin, SolidLocation::Outside);
  EXPECT_EQ(meet.discriminant, 16);
  ASSERT_EQ(meet.along.size(), 2U);
  EXPECT_EQ(meet.along[0].t, Surd(2));
  EXPECT_EQ(meet.along[1].t, Surd(4));
  EXPECT_EQ(meet.along[0].normal, (SurdVec3{-1, 0, 0}));
}

TEST(IntersectRaySphere, AnyRay_MeetsWhatItsLineMeetsAndTellsWhetherItGetsThere) { // law (1)
  RandomNumbers random(101);
  std::map<RaySphereCase, int> cases;
  for (int i = 0; i < 1500; ++i) {
    const Ray<Rational> ray{random.wholeVector(9), random.nonZeroWholeVector(9)};
    const Sphere<Rational> sphere{random.wholeVector(9), abs(random.nonZeroRational(8))};
    const auto meet = intersectRaySphere(ray, sphere);
    const auto line = intersectLineSphere(ray.origin, ray.direction, sphere);
    ++cases[meet.which];
    EXPECT_EQ(meet.contacts, line.contacts);
    EXPECT_EQ(meet.origin, line.origin);
    EXPECT_EQ(meet.discriminant, line.discriminant);
    ASSERT_EQ(meet.along.size(), line.along.size());
    for (std::size_t j = 0; j < line.along.size(); ++j) {
      EXPECT_EQ(meet.along[j].t, line.along[j].t);
      EXPECT_EQ(meet.along[j].point, line.along[j].point);
    }
    EXPECT_EQ(meet.which, line.along.empty()               ? RaySphereCase::Miss
                          : line.along.back().t.sign() < 0 ? RaySphereCase::Behind
                                                           : RaySphereCase::Hit);
  }
  EXPECT_EQ(cases.size(), 3U) << "a case did not come up";
}

TEST(IntersectRaySphere, TangentRay_TouchesExactlyOnceWhereItWasAimed) {
  RandomNumbers random(103);
  for (int i = 0; i < 1000; ++i) {
    Sphere<Rational> sphere{random.vector(), 0};
    const ExactVec3 arm = vectorOfRationalLength(random, sphere.radius);
    const ExactVec3 direction = cross(arm, random.vector());
    if (isZero(direction))
      continue;
    const ExactVec3 touch = sphere.center + arm;
    const Rational t = random.rational(3);
    const auto meet = intersectRaySphere(Ray<Rational>{touch - direction * t, direction}, sphere);
    EXPECT_EQ(meet.discriminant, 0);
    EXPECT_EQ(meet.contacts, SphereContacts::Tangent);
    EXPECT_EQ(meet.which, t < 0 ? RaySphereCase::Behind : RaySphereCase::Hit);
    EXPECT_EQ(meet.origin, t == 0 ? SolidLocation::On : SolidLocation::Outside);
    ASSERT_EQ(meet.along.size(), 1U);
    EXPECT_EQ(meet.along[0].t, Surd(t));
    EXPECT_EQ(meet.along[0].point, (SurdVec3{touch.x, touch.y, touch.z}));
    EXPECT_EQ(meet.along[0].normal[1], Surd(Rational(arm.y / sphere.radius)));
  }
}

TEST(IntersectRaySphere, StartInsideOnOrOutside_IsSaidAndDecidesTheSignsOfT) {
  RandomNumbers random(104);
  for (int i = 0; i < test::effort(500); ++i) {
    Sphere<Rational> sphere{random.vector(), 0};
    const ExactVec3 arm = vectorOfRationalLength(random, sphere.radius);
    const ExactVec3 direction = random.nonZeroWholeVector(9);
    const auto from = [&](const Rational &part) {
      return intersectRaySphere(Ray<Rational>{sphere.center + arm * part, direction}, sphere);
    };
    const auto inside = from(Rational(random.integer(0, 9), 10));
    EXPECT_EQ(inside.origin, SolidLocation::Inside);
    EXPECT_EQ(inside.which, RaySphereCase::Hit);
    EXPECT_EQ(inside.along.front().t.sign() * inside.along.back().t.sign(), -1);
    const auto on = from(1);
    EXPECT_EQ(on.origin, SolidLocation::On);
    EXPECT_EQ(on.which, RaySphereCase::Hit);
    EXPECT_TRUE(on.along.front().t == Surd(0) || on.along.back().t == Surd(0));
    EXPECT_EQ(from(Rational(11, 10)).origin, SolidLocation::Outside);
  }
}

TEST(IntersectRaySphere, ZeroDirection_IsACaseOfItsOwnButKnowsItsPlace) {
  const Sphere<Rational> sphere{ExactVec3(0, 0, 0), 2};
  const auto still = intersectRaySphere(Ray<Rational>{ExactVec3(0, 1, 0), ExactVec3(0, 0, 0)}, sphere);
  EXPECT_EQ(still.which, RaySphereCase::ZeroDirection);
  EXPECT_EQ(still.origin, SolidLocation::Inside);
  EXPECT_TRUE(still.along.empty());
}

TEST(IntersectRaySphere, DoublesOnSmallIntegers_FindTheSameContacts) {
  RandomNumbers random(105);
  // The discriminant is an integer that a double holds; t is a sum of two numbers of at most 40, each with
  // three roundings, and a point 10 times that.
  const double bound = 1e-12;
  for (int i = 0; i < test::effort(2000); ++i) {
    const Ray<Rational> ray{random.wholeVector(9), random.nonZeroWholeVector(9)};
    const Sphere<Rational> sphere{random.wholeVector(9), random.integer(1, 12)};
    const auto exact = intersectRaySphere(ray, sphere);
    const auto rounded = intersectRaySphere(Ray<double>{toDouble(ray.origin), toDouble(ray.direction)},
                                            {toDouble(sphere.center), toDouble(sphere.radius)});
    EXPECT_EQ(rounded.which, exact.which);
    EXPECT_EQ(rounded.origin, exact.origin);
    EXPECT_EQ(rounded.discriminant, toDouble(exact.discriminant));
    ASSERT_EQ(rounded.along.size(), exact.along.size());
    for (std::size_t j = 0; j < exact.along.size(); ++j) {
      EXPECT_NEAR(rounded.along[j].t, toDouble(exact.along[j].t), bound);
      EXPECT_NEAR(rounded.along[j].point[2], toDouble(exact.along[j].point[2]), 10 * bound);
    }
  }
}

} // namespace
} // namespace halfspace
