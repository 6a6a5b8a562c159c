#include "geometry/barycentric.h"

#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <random>

namespace halfspace {
namespace {

using Exact = Vec3<Rational>;
using Corners = Triangle<Rational>;
using Weights = std::array<Rational, 3>;

Rational q(int numerator, int denominator) { return {numerator, denominator}; }

const Corners tilted{{8, 2, 6}, {8, 8, 0}, {0, 8, 4}};

TEST(Barycentric, OfAPointInside_AreSharesOfTheArea) {
  const auto weighed = barycentricOf(Exact(4, 6, 4), tilted);
  EXPECT_EQ(weighed.which, BarycentricCase::InPlane);
  EXPECT_EQ(weighed.weights, (Weights{q(1, 3), q(1, 6), q(1, 2)}));
  EXPECT_EQ(weighed.area, Surd(36));
  EXPECT_EQ(weighed.areas, (std::array{Surd(12), Surd(6), Surd(18)}));
  EXPECT_EQ(weighed.location.part, FacePart::Interior);
}

TEST(Barycentric, OfACorner_AreOneAndTwiceZero) {
  EXPECT_EQ(barycentricOf(tilted.p1, tilted).weights, (Weights{0, 1, 0}));
  EXPECT_EQ(barycentricOf(tilted.p1, tilted).location.part, FacePart::Vertex);
}

TEST(Barycentric, BeyondAnEdge_AreNegativeThere) {
  const auto weighed = barycentricOf(Exact(tilted.p1 + tilted.p2 - tilted.p0), tilted);
  EXPECT_EQ(weighed.weights, (Weights{-1, 1, 1}));
  EXPECT_EQ(weighed.areas[0], Surd(-36));
  EXPECT_EQ(weighed.location.part, FacePart::Outside);
}

TEST(Barycentric, OfAPointOffThePlaneOrWithoutATriangle_AreNotThere) {
  EXPECT_EQ(barycentricOf(Exact(4, 6, 5), tilted).which, BarycentricCase::OffPlane);
  EXPECT_EQ(barycentricOf(Exact(0), Corners{tilted.p0, tilted.p0, tilted.p2}).which,
            BarycentricCase::Coincident);
  EXPECT_EQ(barycentricOf(Exact(0), Corners{{0, 0, 0}, {1, 2, 3}, {3, 6, 9}}).which,
            BarycentricCase::Collinear);
}

TEST(Barycentric, OfAnyPoint_FulfilTheirLaws) {
  std::mt19937_64 engine(4);
  const auto number = [&] {
    return Rational(static_cast<int>(engine() % 41) - 20, 1 + static_cast<int>(engine() % 5));
  };
  const auto vector = [&] {
    const Rational x = number();
    const Rational y = number();
    return Exact(x, y, number());
  };
  for (int i = 0; i < 300; ++i) {
    const Corners corners{vector(), vector(), vector()};
    if (shapeOf(corners) != TriangleShape::Proper)
      continue;
    const Rational s = number();
    const Rational t = number();
    const Exact point = pointOf(corners, s, t);
    const auto weighed = barycentricOf(point, corners);
    ASSERT_EQ(weighed.which, BarycentricCase::InPlane);
    EXPECT_EQ(weighed.weights, (Weights{1 - s - t, s, t})); // law (3), and with it (1)
    for (std::size_t corner = 0; corner < 3; ++corner) {    // law (2)
      const Exact &normal = weighed.normals.at(corner);
      EXPECT_EQ(normal, Exact(weighed.normal * weighed.weights.at(corner)));
      const Surd size = Surd::root(Rational(dot(normal, normal)), q(1, 2));
      EXPECT_EQ(weighed.areas.at(corner), weighed.weights.at(corner) < 0 ? -size : size);
    }
    const auto turned = barycentricOf(point, Corners{corners.p1, corners.p0, corners.p2}); // law (4)
    EXPECT_EQ(turned.weights, (Weights{s, 1 - s - t, t}));
    const auto moved = barycentricOf(Exact(point + (corners.p2 - corners.p1) * number()), corners);
    EXPECT_EQ(moved.weights[0], weighed.weights[0]); // law (5)
  }
}

} // namespace
} // namespace halfspace
