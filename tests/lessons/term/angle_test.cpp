// Angles in degrees, from their cosines.
#include "lessons/term/angle.h"

#include "lessons/term/plain_text.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

std::string degrees(const Surd &cosine) { return relatedText(degreesOf(Term(cosine))); }

TEST(Angle, IsExactWhereItIsAWholeNumberOfDegrees) {
  EXPECT_EQ(degrees(0), " = 90");
  EXPECT_EQ(degrees(1), " = 0");
  EXPECT_EQ(degrees(-1), " = 180");
  EXPECT_EQ(degrees(Rational(-1, 2)), " = 120");
  EXPECT_EQ(degrees(Surd::root(3, Rational(1, 2))), " = 30");
  EXPECT_EQ(degrees(Surd::root(2, Rational(-1, 2))), " = 135");
  EXPECT_EQ(degrees(Surd::root(5, Rational(1, 4)) + Rational(1, 4)), " = 36");
  EXPECT_EQ(degrees(Surd::root(5, Rational(1, 4)) + Rational(-1, 4)), " = 72");
}

TEST(Angle, IsRoundedElsewhere_HoweverNearToAWholeNumber) {
  EXPECT_EQ(degrees(Rational(3, 5)), " ≈ 53.13");
  EXPECT_EQ(degrees(Rational(1, 1000000000)), " ≈ 90");
}

} // namespace
} // namespace halfspace
