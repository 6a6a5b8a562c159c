// The quick ways to a hit against the thorough one.
#include "geometry/quick_hit.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(QuickHit, OverFractions_IsTheHitOfThePerpsByBothWays) {
  RandomNumbers random(165);
  int hits = 0;
  for (int i = 0; i < 5000; ++i) {
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
  EXPECT_GT(hits, 200);
}

TEST(QuickHit, DoublesThatOverflow_AreNoHit) {
  const Triangle<double> triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const Ray<double> besideIt{{5, 5, 1}, {0, 0, -1e-310}};
  EXPECT_FALSE(quickHit(besideIt, prepare(triangle)).hit);
  EXPECT_FALSE(quickHit(besideIt, triangle).hit);
}

} // namespace
} // namespace halfspace
