#include "geometry/exact_root.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(ExactRoot, OfSquaresOfFractions_IsTheFraction) {
  for (const Rational &root :
       {Rational(0), Rational(7), Rational(3, 5), *parseRational("12345678901234567890/7")})
    EXPECT_EQ(exactRoot(root * root), root);
}

TEST(ExactRoot, OfOtherNumbers_IsNone) {
  for (const Rational &value : {Rational(2), Rational(-4), Rational(4, 3), Rational(8, 9)})
    EXPECT_FALSE(exactRoot(value)) << value;
}

} // namespace
} // namespace halfspace
