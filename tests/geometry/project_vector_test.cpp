#include "geometry/project_vector.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(ProjectVector, OntoAnAxis_KeepsThatCoordinate) {
  const auto result = projectVector(ExactVec3(3, 4, 5), ExactVec3(0, 2, 0));
  EXPECT_EQ(result.which, ProjectVectorCase::Projected);
  EXPECT_EQ(result.scalar, Surd(4));
  EXPECT_EQ(result.projection, ExactVec3(0, 4, 0));
  EXPECT_EQ(result.rejection, ExactVec3(3, 0, 5));
}

TEST(ProjectVector, AgainstTheVector_HasANegativeScalar) {
  const auto result = projectVector(ExactVec3(1, 0, 0), ExactVec3(-1, -1, 0));
  EXPECT_EQ(toText(result.scalar), "-1/2*sqrt(2)");
  EXPECT_EQ(result.projection, ExactVec3(Rational(1, 2), Rational(1, 2), 0));
}

TEST(ProjectVector, OntoZero_IsACaseOfItsOwn) {
  const auto result = projectVector(ExactVec3(1, 2, 3), ExactVec3(0, 0, 0));
  EXPECT_EQ(result.which, ProjectVectorCase::ZeroOnto);
  EXPECT_TRUE(isZero(result.projection));
}

TEST(ProjectVector, AnyVectors_SplitIntoAPartAlongAndAPartAcross) {
  RandomNumbers random(71);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 vector = random.vector();
    const ExactVec3 onto = random.nonZeroVector();
    const auto result = projectVector(vector, onto);
    EXPECT_EQ(ExactVec3(result.projection + result.rejection), vector); // law (1)
    EXPECT_EQ(dot(result.rejection, onto), 0);
    EXPECT_TRUE(isZero(cross(result.projection, onto)));
    EXPECT_EQ(result.scalar,
              Surd::root(dot(result.projection, result.projection), dot(vector, onto).sign())); // law (2)
  }
}

TEST(ProjectVector, ProjectedAgain_StaysAsItIs) { // law (3)
  RandomNumbers random(72);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 onto = random.nonZeroVector();
    const auto once = projectVector(random.vector(), onto);
    const auto twice = projectVector(once.projection, onto);
    EXPECT_EQ(twice.projection, once.projection);
    EXPECT_EQ(twice.scalar, once.scalar);
    EXPECT_TRUE(isZero(twice.rejection));
    EXPECT_TRUE(isZero(projectVector(once.rejection, onto).projection));
  }
}

TEST(ProjectVector, LengthAndTurnOfTheOther_ChangeOnlyTheScalarsSign) { // law (4)
  RandomNumbers random(73);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 vector = random.vector();
    const ExactVec3 onto = random.nonZeroVector();
    const Rational k = random.nonZeroRational();
    const auto result = projectVector(vector, onto);
    const auto scaled = projectVector(vector, ExactVec3(onto * k));
    EXPECT_EQ(scaled.projection, result.projection);
    EXPECT_EQ(scaled.rejection, result.rejection);
    EXPECT_EQ(scaled.scalar, k > 0 ? result.scalar : -result.scalar);
  }
}

TEST(ProjectVector, Doubles_AgreeWithFractions) {
  RandomNumbers random(74);
  // Sums of three products of coordinates up to 20, divided by the square of a vector no shorter than 1.
  const double bound = 1e-9;
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 vector = random.vector();
    const ExactVec3 onto = random.nonZeroWholeVector(20);
    const auto exact = projectVector(vector, onto);
    const auto rounded = projectVector(toDouble(vector), toDouble(onto));
    EXPECT_NEAR(rounded.scalar, toDouble(exact.scalar), bound);
    EXPECT_NEAR(rounded.projection.x, toDouble(exact.projection.x), bound);
    EXPECT_NEAR(rounded.rejection.z, toDouble(exact.rejection.z), bound);
  }
}

} // namespace
} // namespace halfspace
