#include "lessons/term/term.h"

#include "tests/lessons/term/term_samples.h"

#include "lessons/term/plain_text.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

const Term u = name(vectorLetter("u"), ExactVec3(1, 2, 3));
const Term v = name(vectorLetter("v"), ExactVec3(4, 5, 6));
const Term half = Rational(1, 2);

TEST(TermValueOf, NumbersUnderEachOperation_IsTheirResult) {
  EXPECT_EQ(valueText(half + 2 - 5), "-5/2");
  EXPECT_EQ(valueText(half * 2 * 7), "7");
  EXPECT_EQ(valueText(3 / half), "6");
  EXPECT_EQ(valueText(-half), "-1/2");
  EXPECT_EQ(valueText(power(half, 3)), "1/8");
  EXPECT_EQ(valueText(power(half, 0)), "1");
  EXPECT_EQ(valueText(power(half, -3)), "8");
  EXPECT_EQ(valueText(root(half)), "1/2*sqrt(2)");
  EXPECT_EQ(valueText(norm(-half)), "1/2");
}

TEST(TermValueOf, VectorsUnderEachOperation_IsTheirResult) {
  EXPECT_EQ(valueText(u + v), "(5, 7, 9)");
  EXPECT_EQ(valueText(u - v), "(-3, -3, -3)");
  EXPECT_EQ(valueText(2 * u), "(2, 4, 6)");
  EXPECT_EQ(valueText(u * half), "(1/2, 1, 3/2)");
  EXPECT_EQ(valueText(u / 2), "(1/2, 1, 3/2)");
  EXPECT_EQ(valueText(dot(u, v)), "32");
  EXPECT_EQ(valueText(cross(u, v)), "(-3, 6, -3)");
  EXPECT_EQ(valueText(norm(u)), "sqrt(14)");
}

TEST(TermValueOf, RowsOfNumbers_IsTheirResult) {
  EXPECT_EQ(valueText(determinant(1, {7})), "7");
  EXPECT_EQ(valueText(determinant(2, {1, 2, 3, 4})), "-2");
  EXPECT_EQ(valueText(determinant(3, {2, 0, 1, 1, 3, 2, 1, 1, 4})), "18");
  EXPECT_EQ(valueText(matrix(2, {1, 2, 3, 4})), "(1, 2, 3, 4)");
  EXPECT_EQ(valueText(list({1, half})), "(1, 1/2)");
}

TEST(TermValueOf, APermutedProduct_IsEachDirectionOnTheOthersMoment) {
  const Term d1 = list({1, 0, 2});
  const Term m1 = list({3, 1, 0});
  EXPECT_EQ(valueText(permuted(d1, m1, u, v)), "21") << "d₁·m₂ = 16, d₂·m₁ = 5";
}

TEST(TermValueOf, UnknownsUnderEachOperation_IsAPolynomial) {
  const Term t = unknown("t");
  EXPECT_EQ(valueText((t + 2) * (t - 2)), "1 t t + -4");
  EXPECT_EQ(valueText(power(t + 1, 2) / 2), "1/2 t t + 1 t + 1/2");
  EXPECT_EQ(valueText(dot(u, v + t * u)), "14 t + 32");
  EXPECT_EQ(valueText(t - t), "0");
}

TEST(TermValueOf, DivisionByZero_IsNothing) {
  EXPECT_EQ(valueText(1 / Term(0)), "nothing");
  EXPECT_EQ(valueText(u / (half - half)), "nothing");
  EXPECT_EQ(valueText(1 / unknown("t")), "nothing") << "t may be zero";
  EXPECT_EQ(valueText(power(0, -1)), "nothing");
}

TEST(TermValueOf, RootsOfWhatIsNegativeOrUnknown_IsNothing) {
  EXPECT_EQ(valueText(root(-half)), "nothing");
  EXPECT_EQ(valueText(root(unknown("t"))), "nothing");
  EXPECT_EQ(valueText(norm(unknown("t"))), "nothing");
}

TEST(TermValueOf, NumbersMixedWithVectors_IsNothing) {
  const Term plane = list({1, 2});
  for (const Term &mixed :
       {u + 1, 1 - u, u * v, dot(u, half), dot(half, u), dot(u, plane), cross(u, plane), cross(half, u),
        1 / u, power(u, 2), root(u), list({u, 1}), u + plane, permuted(u, v, u, 1)})
    EXPECT_FALSE(mixed->value) << valueText(mixed);
}

TEST(TermValueOf, PartsWithoutAValue_IsNothing) {
  const Term theta = name(letter("θ"), std::nullopt);
  EXPECT_EQ(valueText(theta + 1), "nothing");
  EXPECT_EQ(valueText(list({theta, 1})), "nothing");
}

TEST(TermValueOf, NothingToAddOrMultiply_IsWhatChangesNothing) {
  EXPECT_EQ(valueText(sum({})), "0");
  EXPECT_EQ(valueText(product({})), "1");
  EXPECT_EQ(plainText(sum({}) + product({})), "0 + 1");
}

TEST(TermRows, ThatAreNotWhole_AreADefectOfTheCaller) {
  EXPECT_DEBUG_DEATH((void)determinant(2, {1, 2, 3}), "entries");
  EXPECT_DEBUG_DEATH((void)determinant(0, {}), "columns");
  EXPECT_DEBUG_DEATH((void)matrix(2, {1, 2, 3}), "entries");
  EXPECT_DEBUG_DEATH((void)matrix(0, {1}), "columns");
}

TEST(NumberOf, ATerm_IsNullForListsAndUnknowns) {
  ASSERT_NE(numberOf(dot(u, v)), nullptr);
  EXPECT_EQ(textOf(*numberOf(dot(u, v))), "32");
  EXPECT_EQ(numberOf(u), nullptr);
  EXPECT_EQ(numberOf(unknown("t") + 1), nullptr);
  EXPECT_EQ(numberOf(1 / Term(0)), nullptr);
}

TEST(TermSum, OfASum_IsOneSum) {
  EXPECT_EQ((Term(1) + 2 + 3)->parts.size(), 3U);
  EXPECT_EQ((Term(1) + (Term(2) + 3))->parts.size(), 2U) << "parentheses that were written stay";
  EXPECT_EQ((Term(2) * 3 * 4)->parts.size(), 3U);
}

TEST(TermMarked, KeepsEverythingElse) {
  const Term marked = given(letter("P"), {1, 2, 3}, "P", 0).marked("point");
  EXPECT_EQ(marked->mark, "point");
  EXPECT_EQ(marked->symbol, letter("P"));
  EXPECT_EQ(marked->source, (CoordinateSource{"P", 0, std::nullopt}));
  EXPECT_EQ(valueText(marked), "(1, 2, 3)");
}

TEST(TermMarked, IsNotDissolvedInALargerSum) {
  const Term sum = (Term(1) + 2).marked("part") + 3;
  ASSERT_EQ(sum->parts.size(), 2U);
  EXPECT_EQ(sum->parts[0]->mark, "part");
}

TEST(WithParts, IsTheSameOperationWithoutTheMark) {
  const Term changed = withParts(determinant(2, {1, 2, 3, 4}).marked("det"), {1, 2, 3, 5});
  EXPECT_EQ(valueText(changed), "-1");
  EXPECT_EQ(changed->columns, 2U);
  EXPECT_TRUE(changed->mark.empty());
}

TEST(ReadAlike, OfTermsThatLookTheSame_IsTrue) {
  EXPECT_TRUE(readAlike(u + v, u.marked("u") + v));
  EXPECT_TRUE(readAlike(number(Rational(3), u), 3)) << "where a number comes from is not seen";
  EXPECT_TRUE(readAlike(-half, Rational(-1, 2)));
  EXPECT_TRUE(readAlike(Term(-1) / 2, Rational(-1, 2))) << "the numerator's sign is the fraction's";
  EXPECT_TRUE(readAlike(Term(1) / 2, half));
}

TEST(ReadAlike, OfTermsThatLookDifferent_IsFalse) {
  EXPECT_FALSE(readAlike(u, v));
  EXPECT_FALSE(readAlike(u + v, v + u));
  EXPECT_FALSE(readAlike(u + v, u - v));
  EXPECT_FALSE(readAlike(dot(u, v), cross(u, v)));
  EXPECT_FALSE(readAlike(half, -half));
  EXPECT_FALSE(readAlike(Term(2) / 4, half));
  EXPECT_FALSE(readAlike(name(vectorLetter("n"), std::nullopt), name(letter("n"), std::nullopt)));
  EXPECT_FALSE(readAlike(list({1, 2}), list({1, 2, 3})));
  EXPECT_FALSE(readAlike(matrix(2, {1, 2, 3, 4, 5, 6}), matrix(3, {1, 2, 3, 4, 5, 6})));
}

} // namespace
} // namespace halfspace
