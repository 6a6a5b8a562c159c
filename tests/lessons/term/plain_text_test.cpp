#include "lessons/term/plain_text.h"

#include "lessons/term/prime.h"

#include "tests/lessons/term/term_samples.h"

#include "lessons/term/rewrite.h"
#include "tests/lessons/spoken_to_in.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

const NoteTerms at;
const Term a = unknown("a");
const Term b = unknown("b");
const Term c = unknown("c");

TEST(PlainText, OfFractions_HasParenthesesAroundAllThatASlashWouldTearApart) {
  EXPECT_EQ(plainText((a + b) / c), "(a + b)/c");
  EXPECT_EQ(plainText(a / (b * c)), "a/(b c)");
  EXPECT_EQ(plainText(a / b / c), "(a/b)/c");
  EXPECT_EQ(plainText(a / (b / c)), "a/(b/c)");
  EXPECT_EQ(plainText(dot(at.n, at.Q) / norm(at.n)), "(n·Q)/|n|");
  EXPECT_EQ(plainText(power(a, 2) / b), "a²/b");
  EXPECT_EQ(plainText(Term(-2) / 3), "−2/3");
  EXPECT_EQ(plainText(Term(2) / -3), "2/(−3)");
}

TEST(PlainText, OfAFractionThatIsAFactor_CannotBeReadOtherwise) {
  EXPECT_EQ(plainText(a / b * c), "(a/b) c");
  EXPECT_EQ(plainText(Rational(1, 3) * a), "(1/3)a");
  EXPECT_EQ(plainText(a * (b / c)), "a b/c");
  EXPECT_EQ(plainText(power(a / b, 2)), "(a/b)²");
}

TEST(PlainText, OfANegativeFraction_IsInParenthesesBehindASign) {
  const Term negative = Term(-30) / 9;
  EXPECT_EQ(plainText(negative + a), "−30/9 + a");
  EXPECT_EQ(plainText(a + negative), "a + (−30/9)");
  EXPECT_EQ(plainText(a - negative), "a − (−30/9)");
  EXPECT_EQ(plainText(2 * negative), "2·(−30/9)");
  EXPECT_EQ(plainText(-negative), "−(−30/9)");
}

TEST(PlainText, OfRoots_HoldsTheirContentTogether) {
  EXPECT_EQ(plainText(root(2)), "√2");
  EXPECT_EQ(plainText(root(dot(at.n, at.n))), "√(n·n)");
  EXPECT_EQ(plainText(root(a / b)), "√(a/b)");
  EXPECT_EQ(plainText(root(power(a, 2))), "√(a²)");
  EXPECT_EQ(plainText(power(root(2), 2)), "(√2)²");
  EXPECT_EQ(plainText(root(2) * a), "(√2) a");
}

TEST(PlainText, OfPowers_RaisesTheirExponents) {
  EXPECT_EQ(plainText(power(a, 12)), "a¹²");
  EXPECT_EQ(plainText(power(a, -2)), "a⁻²");
  EXPECT_EQ(plainText(power(-a, 2)), "(−a)²");
}

TEST(PlainText, OfNames_LowersTheirIndices) {
  EXPECT_EQ(plainText(at.P0), "P₀");
  EXPECT_EQ(plainText(vectorLetter("n", "f")), "n_f");
  EXPECT_EQ(plainText(perpLetter("u")), "u⊥");
  EXPECT_EQ(plainText(primed(vectorLetter("v"))), "v′");
  EXPECT_EQ(plainText(at.f), "f(Q)");
  EXPECT_EQ(plainText(applied(word("cos"), name(letter("θ"), std::nullopt), Real(1))), "cos θ");
}

TEST(PlainText, OfRowsOfNumbers_PartsThem) {
  EXPECT_EQ(plainText(list({1, Rational(1, 2), -3})), "(1, 1/2, −3)");
  EXPECT_EQ(plainText(determinant(2, {1, 2, 3, 4})), "det[1 2; 3 4]");
  EXPECT_EQ(plainText(permuted(a, b, c, a)), "(a, b) ∗ (c, a)");
}

TEST(PlainText, WithADecimalComma_PartsListsBySemicolons) {
  const test::SpokenToIn language(test::withDecimalComma());
  EXPECT_EQ(plainText(list({Rational(637, 100), 2})), "(6,37; 2)");
  EXPECT_EQ(relatedText(Rational(1'000'000'007, 3'000'000'019)), " ≈ 0,333333");
}

TEST(PlainText, OfPartOfAChain_BeginsWithItsRelation) {
  const Chain chain = withNumbers(at.f == dot(at.n, at.Q - at.P0));
  EXPECT_EQ(plainText(chain, 0, 1), "f(Q)");
  EXPECT_EQ(plainText(chain, 3, 4), " = 30");
}

} // namespace
} // namespace halfspace
