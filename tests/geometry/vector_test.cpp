#include "geometry/vector.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(Cross, FirstAxisBySecond_IsTheThird) {
  EXPECT_EQ(cross(ExactVec3(1, 0, 0), ExactVec3(0, 1, 0)), ExactVec3(0, 0, 1));
  EXPECT_EQ(cross(ExactVec3(0, 1, 0), ExactVec3(0, 0, 1)), ExactVec3(1, 0, 0));
  EXPECT_EQ(cross(ExactVec3(0, 0, 1), ExactVec3(1, 0, 0)), ExactVec3(0, 1, 0));
}

TEST(Cross, AnyVectors_ObeyItsLaws) {
  RandomNumbers random(171);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 a = random.vector();
    const ExactVec3 b = i % 4 == 0 ? ExactVec3(a * random.rational(2)) : random.vector();
    const ExactVec3 c = random.vector();
    const ExactVec3 product = cross(a, b);
    EXPECT_EQ(cross(b, a), ExactVec3(-product)); // law (1)
    EXPECT_EQ(dot(a, product), 0);               // law (2)
    EXPECT_EQ(dot(b, product), 0);
    const Rational ab = dot(a, b);
    EXPECT_EQ(dot(product, product), dot(a, a) * dot(b, b) - ab * ab); // law (3)
    EXPECT_EQ(dot(a, cross(b, c)), dot(c, product));                   // law (4)
    EXPECT_EQ(dot(b, cross(c, a)), dot(c, product));
  }
}

TEST(Cross, MultiplesAndTheZeroVector_GiveZeroAndNothingElseDoes) { // law (3)
  RandomNumbers random(172);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 a = random.nonZeroWholeVector(2);
    const ExactVec3 b = random.wholeVector(2);
    const ExactVec3 part = a * Rational(dot(a, b) / dot(a, a));
    EXPECT_EQ(isZero(cross(a, b)), b == part);
    EXPECT_TRUE(isZero(cross(a, ExactVec3(0, 0, 0))));
  }
}

} // namespace
} // namespace halfspace
