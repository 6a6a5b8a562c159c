#include "geometry/hit_all.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Triangles = std::vector<Triangle<Rational>>;

TriangleHits<Rational> hitsOf(const Ray<Rational> &ray, const Triangles &triangles) {
  return hitAll(ray, std::span<const Triangle<Rational>>(triangles));
}

std::vector<std::size_t> order(const TriangleHits<Rational> &all) {
  std::vector<std::size_t> indices;
  for (const auto &hit : all.hits)
    indices.push_back(hit.index);
  return indices;
}

/// Around the z axis, in the plane of this height.
Triangle<Rational> levelAt(const Rational &z) {
  return {ExactVec3(-3, -3, z), ExactVec3(3, -3, z), ExactVec3(0, 3, z)};
}

const Ray<Rational> up{ExactVec3(0, 0, 0), ExactVec3(0, 0, 2)};

TEST(HitAll, LevelsInAnyOrder_AreSortedByTAndTiesByIndex) {
  const auto all = hitsOf(up, {levelAt(8), levelAt(2), levelAt(-1), levelAt(8), levelAt(0), levelAt(2)});
  EXPECT_EQ(order(all), (std::vector<std::size_t>{4, 1, 5, 0, 3}));
  EXPECT_EQ(all.hits[0].t, 0);
  EXPECT_EQ(all.hits[1].t, 1);
  EXPECT_EQ(all.hits[1].point, ExactVec3(0, 0, 2));
  EXPECT_TRUE(all.skipped.empty());
}

TEST(HitAll, DegenerateAndInPlaneTriangles_AreSkippedAndParallelOnesNot) {
  const ExactVec3 a(0, 0, 1);
  const ExactVec3 b(0, 0, 2);
  const ExactVec3 c(0, 0, 3);
  const ExactVec3 aside(5, 0, 0);
  const ExactVec3 far(5, 5, 0);
  const auto all = hitsOf(up, {{a, a, b}, levelAt(1), {a, b, c}, {a, b, aside}, {aside, far, far + b}});
  EXPECT_EQ(order(all), (std::vector<std::size_t>{1}));
  EXPECT_EQ(all.skipped, (std::vector<std::size_t>{0, 2, 3}));
}

TEST(HitAll, NoTriangles_AreNoHits) {
  EXPECT_TRUE(hitsOf(up, {}).hits.empty());
  EXPECT_TRUE(hitsOf(up, {}).skipped.empty());
}

TEST(HitAll, ManyTriangles_GiveThoseThatAreHitOneByOneInOrder) { // laws (1) to (3)
  RandomNumbers random(131);
  std::size_t hits = 0;
  for (int i = 0; i < 100; ++i) {
    Triangles triangles;
    for (int j = 0; j < 40; ++j)
      triangles.push_back({random.wholeVector(3), random.wholeVector(3), random.wholeVector(3)});
    const Ray<Rational> ray{random.wholeVector(3), random.nonZeroWholeVector(3)};
    std::vector<std::pair<Rational, std::size_t>> expected;
    std::vector<std::size_t> skipped;
    for (std::size_t j = 0; j < triangles.size(); ++j) {
      const auto meet = intersectRayTriangle(ray, triangles[j]);
      if (meet.which == RayTriangleCase::Hit)
        expected.emplace_back(meet.plane.t, j);
      if (shapeOf(triangles[j]) != TriangleShape::Proper || meet.which == RayTriangleCase::InPlane)
        skipped.push_back(j);
    }
    std::sort(expected.begin(), expected.end());
    const auto all = hitsOf(ray, triangles);
    hits += all.hits.size();
    ASSERT_EQ(all.hits.size(), expected.size());
    for (std::size_t j = 0; j < expected.size(); ++j) {
      EXPECT_EQ(all.hits[j].t, expected[j].first);
      EXPECT_EQ(all.hits[j].index, expected[j].second);
      EXPECT_EQ(all.hits[j].point, pointAt(ray, expected[j].first));
    }
    EXPECT_EQ(all.skipped, skipped);
  }
  EXPECT_GT(hits, 100U);
}

TEST(HitAll, TrianglesAHairApart_KeepTheirOrder) {
  for (int k = 0; k <= 60; ++k) {
    const Rational hair = powerOfTen(-k);
    EXPECT_EQ(order(hitsOf(up, {levelAt(Rational(1 + hair)), levelAt(1)})), (std::vector<std::size_t>{1, 0}));
  }
}

} // namespace
} // namespace halfspace
