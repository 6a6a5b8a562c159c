// Points in front of a plane by nested boxes, against looking at each.
#include "geometry/integer.h"
#include "geometry/vertex_tree.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Points = std::vector<WeightedPoint<Rational>>;

bool someInFront(const Points &points, const Plane<Rational> &plane) {
  return std::any_of(points.begin(), points.end(),
                     [&](const auto &point) { return evaluate(plane, point) > 0; });
}

/// Through three of the points, moved by a little or not at all, with either side in front.
Plane<Rational> somePlane(const Points &points, RandomNumbers &random) {
  const auto any = [&] {
    return points[static_cast<std::size_t>(random.integer(0, static_cast<int>(points.size()) - 1))];
  };
  Plane<Rational> plane = planeThrough(any(), any(), any());
  plane.offset += random.integer(-1, 1);
  if (random.integer(0, 1) == 0)
    plane = {-plane.normal, Rational(-plane.offset)};
  return plane;
}

TEST(VertexTree, PointsOfAnySizeHoweverFarAway_AreInFrontAsOneByOne) { // law (1)
  RandomNumbers random(178);
  int inFront = 0;
  constexpr int questions = 6000;
  for (int i = 0; i < questions / 20; ++i) {
    const Rational scale = powerOfTen(random.integer(-40, 40)) / 3;
    const ExactVec3 far = random.wholeVector(1) * powerOfTen(random.integer(0, 60));
    Points points;
    for (int count = random.integer(1, 60); count > 0; --count)
      points.push_back(weighted(ExactVec3(far + random.wholeVector(4) * scale)));
    const VertexTree<Rational> tree(points);
    for (int j = 0; j < 20; ++j) {
      const auto plane = somePlane(points, random);
      const bool expected = someInFront(points, plane);
      inFront += expected ? 1 : 0;
      ASSERT_EQ(tree.hasInFront(plane), expected) << "points " << i << ", plane " << j;
    }
  }
  // Both answers come up often.
  EXPECT_GT(inFront, questions / 10);
  EXPECT_LT(inFront, questions * 9 / 10);
}

TEST(VertexTree, PlaneMovedOverTheOutermostPoint_HasItInFrontOnlyBeyond) { // law (1)
  Points points;
  for (int x = 0; x < 40; ++x)
    points.push_back(weighted(ExactVec3(x, -x, Rational(x, 7))));
  const VertexTree<Rational> tree(points);
  for (int k = 0; k <= 60; ++k) {
    const Rational unit = powerOfTen(k);
    const auto upTo = [&](const Rational &offset) {
      return Plane<Rational>{ExactVec3(unit, 0, 0), Rational(-39 * unit + offset)};
    };
    EXPECT_FALSE(tree.hasInFront(upTo(0)));
    EXPECT_TRUE(tree.hasInFront(upTo(1)));
    EXPECT_FALSE(tree.hasInFront(upTo(-1)));
  }
}

TEST(BinaryExponent, AnyWholeNumbers_IsWithinOneOfTheQuotients) { // law (1)
  RandomNumbers random(179);
  for (int i = 0; i < test::effort(3000); ++i) {
    const auto someWhole = [&] {
      const Rational whole = random.integer(1, 70) * powerOfTen(random.integer(0, 40));
      return random.integer(0, 1) == 0 ? whole : Rational(-whole);
    };
    const Rational p = someWhole();
    const Rational q = abs(someWhole());
    const int exponent = binaryExponent(p, q);
    const Rational power = rationalOf(Integer(1) << std::abs(exponent));
    const Rational scaled = abs(p) / q * (exponent < 0 ? power : Rational(1 / power));
    EXPECT_LT(scaled, 2);
    EXPECT_GT(scaled, Rational(1, 2));
    EXPECT_EQ(nearestQuotient(p, q, 3), toDouble(Rational(p / q * 8)));
  }
}

} // namespace
} // namespace halfspace
