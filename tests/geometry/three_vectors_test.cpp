#include "geometry/three_vectors.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Case = ThreeVectorsCase;

Case caseOf(const ExactVec3 &u, const ExactVec3 &v, const ExactVec3 &w) {
  return relateVectors(u, v, w).which;
}

Rational determinantOf(const ExactVec3 &u, const ExactVec3 &v, const ExactVec3 &w) {
  return relateVectors(u, v, w).determinant;
}

TEST(RelateVectors, OfTheAxes_AreRightHandedWithTheVolumeOne) {
  const auto axes = relateVectors(ExactVec3(1, 0, 0), ExactVec3(0, 1, 0), ExactVec3(0, 0, 1));
  EXPECT_EQ(axes.which, Case::RightHanded);
  EXPECT_EQ(axes.determinant, 1);
  EXPECT_EQ(axes.normal, ExactVec3(0, 0, 1));
}

TEST(RelateVectors, OfASlantedBox_HaveBaseTimesHeight) {
  const auto box = relateVectors(ExactVec3(4, -1, 0), ExactVec3(0, 4, 2), ExactVec3(1, 1, 4));
  EXPECT_EQ(box.normal, ExactVec3(-2, -8, 16)); // 18 long, and the box is 3 high
  EXPECT_EQ(box.determinant, 54);
  EXPECT_EQ(box.other, ExactVec3(14, 2, -4));
  EXPECT_EQ(box.twice, ExactVec3(4, 16, 22));
}

TEST(RelateVectors, WithoutAVolume_TellWhy) {
  const ExactVec3 u(4, -1, 0);
  const ExactVec3 v(0, 4, 2);
  EXPECT_EQ(caseOf(u, v, ExactVec3(u * Rational(2) - v)), Case::Flat);
  EXPECT_EQ(caseOf(u, v, ExactVec3(-v)), Case::Parallel);
  EXPECT_EQ(caseOf(u, v, u), Case::Parallel);
  EXPECT_EQ(caseOf(u, u, v), Case::Parallel);
  EXPECT_EQ(caseOf(u, v, ExactVec3(0)), Case::ZeroVector);
  EXPECT_EQ(caseOf(u, ExactVec3(0), u), Case::ZeroVector);
}

TEST(RelateVectors, InAnotherOrder_ChangeTheSignOrNothing) { // law (1)
  RandomNumbers random(81);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 u = random.vector();
    const ExactVec3 v = random.vector();
    const ExactVec3 w = random.vector();
    const Rational determinant = determinantOf(u, v, w);
    EXPECT_EQ(determinantOf(v, w, u), determinant);
    EXPECT_EQ(determinantOf(w, u, v), determinant);
    EXPECT_EQ(determinantOf(v, u, w), -determinant);
    EXPECT_EQ(determinantOf(u, w, v), -determinant);
    EXPECT_EQ(determinantOf(w, v, u), -determinant);
    EXPECT_EQ(determinant == 0, caseOf(u, v, w) >= Case::Flat); // law (2)
  }
}

TEST(RelateVectors, SlidAlongTheBase_KeepTheVolume) { // law (3)
  RandomNumbers random(82);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 u = random.vector();
    const ExactVec3 v = random.vector();
    const ExactVec3 w = random.vector();
    const Rational k = random.rational();
    const ExactVec3 slid = w + u * k + v * random.rational();
    EXPECT_EQ(determinantOf(u, v, slid), determinantOf(u, v, w));
    EXPECT_EQ(determinantOf(u, v, ExactVec3(w * k)), k * determinantOf(u, v, w));
    EXPECT_EQ(determinantOf(u, v, ExactVec3(slid - w)), 0);
  }
}

TEST(RelateVectors, OfGivenLengths_SpanMostWhereTheyArePerpendicular) { // law (4)
  RandomNumbers random(83);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 u = random.vector();
    ExactVec3 v = random.vector();
    ExactVec3 w = random.vector();
    if (i % 3 == 0)
      v = cross(u, v);
    if (i % 6 == 0)
      w = cross(u, v);
    const Rational determinant = determinantOf(u, v, w);
    const Rational most = dot(u, u) * dot(v, v) * dot(w, w);
    const bool areAcross = dot(u, v) == 0 && dot(v, w) == 0 && dot(w, u) == 0;
    EXPECT_LE(determinant * determinant, most);
    EXPECT_EQ(determinant * determinant == most, areAcross || most == 0);
  }
}

TEST(RelateVectors, MultipliedCrosswiseTwice_StayInThePlaneOfTheLastTwo) { // law (5)
  RandomNumbers random(84);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 u = random.vector();
    const ExactVec3 v = random.vector();
    const ExactVec3 w = random.vector();
    const auto three = relateVectors(u, v, w);
    EXPECT_EQ(three.twice, ExactVec3(v * dot(u, w) - w * dot(u, v)));
    EXPECT_EQ(dot(three.twice, u), 0);
    EXPECT_EQ(dot(three.twice, three.other), 0);
    EXPECT_EQ(determinantOf(v, w, three.twice), 0);
  }
}

} // namespace
} // namespace halfspace
