// The quick ways to a hit against the thorough one.
#include "geometry/quick_hit.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(Prepare, AnyProperTriangle_HasFormsThatTellItsCornersApart) {
  RandomNumbers random(197);
  for (int i = 0; i < test::effort(500); ++i) {
    const Triangle<Rational> triangle = random.properTriangle();
    const auto prepared = prepare(triangle);
    const auto formsAt = [&](const ExactVec3 &x) { // law (1)
      return ExactVec3(evaluate(prepared.plane, x), evaluate(prepared.s, x), evaluate(prepared.t, x));
    };
    EXPECT_EQ(formsAt(triangle.p0), ExactVec3(0, 0, 0));
    EXPECT_EQ(formsAt(triangle.p1), ExactVec3(0, 1, 0));
    EXPECT_EQ(formsAt(triangle.p2), ExactVec3(0, 0, 1));
    const auto plane = planeThrough(triangle.p0, triangle.p1, triangle.p2); // law (2)
    EXPECT_EQ(prepared.plane.normal, plane.normal);
    EXPECT_EQ(prepared.plane.offset, plane.offset);
  }
}

TEST(QuickHit, OverFractions_IsTheHitOfThePerpsByBothWays) { // law (1)
  RandomNumbers random(165);
  int hits = 0;
  for (int i = 0; i < test::effort(5000); ++i) {
    const Triangle<Rational> triangle{random.wholeVector(3), random.wholeVector(3), random.wholeVector(3)};
    if (shapeOf(triangle) != TriangleShape::Proper)
      continue;
    const Ray<Rational> ray{random.wholeVector(3), random.nonZeroWholeVector(3)};
    const auto meet = intersectRayTriangle(ray, triangle);
    hits += meet.which == RayTriangleCase::Hit ? 1 : 0;
    for (const auto &quick : {quickHit(ray, triangle), quickHit(ray, prepare(triangle))}) {
      ASSERT_EQ(quick.hit, meet.which == RayTriangleCase::Hit);
      if (quick.hit) {
        EXPECT_EQ(quick.t, meet.plane.t);
        EXPECT_EQ(quick.s, meet.s);
        EXPECT_EQ(quick.tTriangle, meet.tTriangle);
      }
    }
  }
  EXPECT_GT(hits, test::effort(200));
}

TEST(QuickHit, DegenerateTriangleOrNoDirection_IsNoHit) { // law (1)
  const ExactVec3 a(1, 2, 3);
  const ExactVec3 zero(0, 0, 0);
  const Triangle<Rational> proper{a, ExactVec3(3, 0, 0), ExactVec3(0, 4, 0)};
  EXPECT_FALSE(quickHit(Ray<Rational>{zero, a}, Triangle<Rational>{a, a, a}).hit);
  EXPECT_FALSE(quickHit(Ray<Rational>{zero, a}, Triangle<Rational>{zero, a, a + a}).hit);
  EXPECT_FALSE(quickHit(Ray<Rational>{a, zero}, proper).hit);
  EXPECT_FALSE(quickHit(Ray<Rational>{a, zero}, prepare(proper)).hit);
}

TEST(QuickHit, DoublesThatOverflow_AreNoHit) {
  const Triangle<double> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Ray<double> besideIt{{5, 5, 1}, {0, 0, -1e-310}};
  EXPECT_FALSE(quickHit(besideIt, prepare(triangle)).hit);
  EXPECT_FALSE(quickHit(besideIt, triangle).hit);
}

} // namespace
} // namespace halfspace
