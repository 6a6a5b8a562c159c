#include "lessons/term/term_value.h"

#include "tests/lessons/term/term_samples.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

const Polynomial x = Polynomial::unknown("x");
const Polynomial y = Polynomial::unknown("y");

Polynomial number(int value) { return Real(value); }

/// Between bounds only.
/// A number that is known by its bounds alone.
Real oneOverRoots() { return quotient(Real(1), Real(Surd::root(2)) + Real(Surd::root(3))).value(); }

TEST(Polynomial, OfSums_IsCollected) {
  EXPECT_EQ(textOf(number(2) * x + number(3) * x + number(1)), "5 x + 1");
  EXPECT_EQ(textOf(y + x + x * x + y * x), "1 x x + 1 x y + 1 x + 1 y + 0");
}

TEST(Polynomial, OfWhatCancels_HasNoUnknowns) {
  const Polynomial rest = x + number(4) - x;
  EXPECT_FALSE(rest.hasUnknowns());
  ASSERT_NE(rest.number(), nullptr);
  EXPECT_EQ(textOf(*rest.number()), "4");
  EXPECT_EQ(textOf(number(0) * x), "0");
}

TEST(Polynomial, WithUnknowns_IsNoNumber) { EXPECT_EQ((x + number(4)).number(), nullptr); }

TEST(PolynomialProduct, OfTwoSums_IsMultipliedOut) {
  EXPECT_EQ(textOf((x + number(2)) * (x - number(2))), "1 x x + -4");
  EXPECT_EQ(textOf((x + y) * (y + x)), "1 x x + 2 x y + 1 y y + 0");
  EXPECT_EQ(textOf(-(x - number(3)) * number(2)), "-2 x + 6");
}

TEST(AreEqual, OfPolynomials_ComparesThemForAllUnknowns) {
  EXPECT_EQ(
      areEqual(TermValue((x + number(1)) * (x + number(1))), TermValue(x * x + number(2) * x + number(1))),
      true);
  EXPECT_EQ(areEqual(TermValue(x * x), TermValue(x)), false);
  EXPECT_EQ(areEqual(TermValue(x), TermValue(y)), false);
}

TEST(AreEqual, OfFactorsBetweenBounds_IsLeftOpen) {
  const TermValue value(Polynomial(oneOverRoots()) * x);
  EXPECT_EQ(areEqual(value, value), std::nullopt);
  EXPECT_EQ(areEqual(value, TermValue(number(3) * x)), false);
}

TEST(AreEqual, OfLists_ComparesEntryByEntry) {
  const TermValue list(ExactVec3(1, 2, 3));
  EXPECT_EQ(areEqual(list, TermValue::list({Real(1), Real(2), Real(3)})), true);
  EXPECT_EQ(areEqual(list, TermValue(ExactVec3(1, 2, 4))), false);
  EXPECT_EQ(areEqual(list, TermValue::list({Real(1), Real(2)})), false);
  EXPECT_EQ(areEqual(TermValue::list({Real(1)}), TermValue(Real(1))), false) << "a list of one is no number";
}

TEST(AreEqual, OfListsWithOneOpenEntry_IsFalseWhereAnotherDiffers) {
  const auto list = [](int last) {
    return TermValue::list({Polynomial(oneOverRoots()), Polynomial(Real(last))});
  };
  EXPECT_EQ(areEqual(list(1), list(1)), std::nullopt);
  EXPECT_EQ(areEqual(list(1), list(2)), false);
}

} // namespace
} // namespace halfspace
