#include "lessons/object/quadric.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using test::q;

Rational offSphere(const ExactVec3 &place) {
  const ExactVec3 way = place - ExactVec3(1, 2, 3);
  return dot(way, way) - 9;
}

/// With all products of two coordinates.
Rational mixed(const ExactVec3 &p) {
  return 2 * p.x * p.x - 3 * p.x * p.y + p.y * p.z + q(1, 2) * p.z * p.x - p.z * p.z + 5 * p.y - 7;
}

TEST(Quadric, OfAPolynomial_IsThatPolynomialEverywhere) {
  for (const auto &function : {Quadric::Function(offSphere), Quadric::Function(mixed)}) {
    const auto surface = Quadric::of(function);
    ASSERT_TRUE(surface);
    for (const ExactVec3 &place : {ExactVec3(0), ExactVec3(q(1, 3), -5, q(7, 2)), ExactVec3(11, 15, 8)})
      EXPECT_EQ(surface->at(place), function(place));
  }
}

TEST(Quadric, ThroughProbesAroundAPlace_IsTheSameAsAroundAnother) {
  const ExactVec3 around(4, q(-1, 2), 9);
  std::array<Rational, Quadric::probeCount> values;
  const auto places = Quadric::probes(around);
  for (std::size_t i = 0; i < places.size(); ++i)
    values.at(i) = mixed(places.at(i));
  const auto surface = Quadric::through(around, values);
  ASSERT_TRUE(surface);
  EXPECT_EQ(surface->at({1, -2, q(3, 4)}), mixed({1, -2, q(3, 4)}));
}

TEST(Quadric, AlongALine_IsThePolynomialOfItsParameter) {
  const auto [square, linear, constant] = Quadric::of(mixed)->along({1, 2, 3}, {2, -1, 5});
  for (const int t : {-2, 0, 1, 4})
    EXPECT_EQ(square * t * t + linear * t + constant, mixed(ExactVec3(1, 2, 3) + ExactVec3(2, -1, 5) * q(t)));
}

TEST(Quadric, OfWhatIsNotOfSecondDegree_OrOnlyFlat_IsNone) {
  EXPECT_FALSE(Quadric::of([](const ExactVec3 &p) { return p.x * p.x * p.x; }));
  EXPECT_FALSE(Quadric::of([](const ExactVec3 &p) { return p.x + 2 * p.y - 1; }));
  EXPECT_FALSE(Quadric::of([](const ExactVec3 &p) { return (p.x + p.y) * (p.x + p.y) - 2; })) << "two planes";
  EXPECT_FALSE(Quadric::of([](const ExactVec3 &) { return Rational(0); }));
}

} // namespace
} // namespace halfspace
