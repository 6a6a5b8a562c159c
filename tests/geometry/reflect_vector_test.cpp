#include "geometry/reflect_vector.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(ReflectVector, AtALevelMirror_TurnsTheHeightRound) {
  EXPECT_EQ(reflectVector(ExactVec3(3, 4, -5), ExactVec3(0, 0, 2)), ExactVec3(3, 4, 5));
}

TEST(ReflectVector, AtATiltedMirror_IsExact) {
  EXPECT_EQ(reflectVector(ExactVec3(0, 0, -9), ExactVec3(2, 1, 2)), ExactVec3(8, 4, -1));
}

TEST(ReflectVector, AtAnyMirror_TurnsOnlyThePartAlongTheNormalAndKeepsTheLength) {
  RandomNumbers random(81);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 vector = random.vector();
    const ExactVec3 normal = random.nonZeroVector();
    const ExactVec3 reflected = reflectVector(vector, normal);
    EXPECT_EQ(dot(reflected, normal), Rational(-dot(vector, normal))); // law (1)
    EXPECT_EQ(cross(reflected, normal), cross(vector, normal));
    EXPECT_EQ(dot(reflected, reflected), dot(vector, vector)); // law (2)
    EXPECT_EQ(reflectVector(reflected, normal), vector);       // law (3)
  }
}

TEST(ReflectVector, LengthAndSideOfTheNormal_ChangeNothing) { // law (4)
  RandomNumbers random(82);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 vector = random.vector();
    const ExactVec3 normal = random.nonZeroVector();
    const Rational k = random.nonZeroRational();
    EXPECT_EQ(reflectVector(vector, ExactVec3(normal * k)), reflectVector(vector, normal));
  }
}

} // namespace
} // namespace halfspace
