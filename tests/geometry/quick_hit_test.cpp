// The quick ways to a hit against the thorough one, and how far and how long a ray may be for them.
#include "geometry/hit_finder.h"
#include "geometry/quick_hit.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

TEST(HitFinder, DirectionOfAnyLength_FindsTheSameTriangle) {
  const std::vector<Triangle<double>> triangles{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}},
                                                {{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}};
  const HitFinder finder(triangles);
  for (int exponent = -1074; exponent <= 1023; ++exponent) {
    const Ray<double> ray{{0, 0, 3}, {0, 0, -std::ldexp(1.0, exponent)}};
    const auto found = finder.find(ray);
    ASSERT_TRUE(found) << exponent;
    EXPECT_EQ(found->index, 1U);
    EXPECT_EQ(found->t, std::ldexp(2.0, -exponent)) << exponent;
  }
}

TEST(HitFinder, OriginHoweverFar_FindsTheTriangle) {
  const std::vector<Triangle<double>> triangles{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}};
  const HitFinder finder(triangles);
  for (int exponent = 0; exponent <= 1000; ++exponent) {
    const double height = std::ldexp(1.0, exponent);
    const auto found = finder.find({{0.25, 0.25, height}, {0, 0, -1}});
    ASSERT_TRUE(found) << exponent;
    EXPECT_EQ(found->t, height);
    EXPECT_FALSE(finder.find({{0.25, 0.25, height}, {0, 0, 1}})) << exponent;
  }
}

} // namespace
} // namespace halfspace
