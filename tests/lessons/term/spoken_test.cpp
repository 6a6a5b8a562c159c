#include "lessons/term/spoken.h"

#include "lessons/pseudo_language.h"
#include "lessons/term/greek.h"
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
const Term theta = name(letter("θ"), std::nullopt);

TEST(Spoken, OfAChain_SaysItsRelations) {
  EXPECT_EQ(spoken(withNumbers(name(letter("t"), Rational(-10, 3)) == Term(-30) / 9)),
            "t equals minus 30 over 9 equals minus 10 over 3");
  EXPECT_EQ(spoken(compared(at.f, 0)), "f of Q is greater than 0");
  EXPECT_EQ(spoken(withResult(root(2) + root(3))),
            "the square root of 2 end of root plus the square root of 3 end of root is about 3.14626");
}

TEST(Spoken, OfParts_SaysWhereTheyEnd) {
  EXPECT_EQ(spoken(dot(at.n, at.Q - at.P0)), "n dot open parenthesis Q minus P 0 close parenthesis");
  EXPECT_EQ(spoken((a + b) / 2), "the fraction a plus b over 2 end of fraction");
  EXPECT_EQ(spoken(root(a + b)), "the square root of a plus b end of root");
}

TEST(Spoken, OfFractionsInFractions_SaysWhereEachEnds) {
  const Term c = unknown("c");
  EXPECT_EQ(spoken(a / b), "a over b");
  EXPECT_EQ(spoken(a / b / c), "the fraction the fraction a over b end of fraction over c end of fraction");
  EXPECT_EQ(spoken(a / (b / c)), "the fraction a over the fraction b over c end of fraction end of fraction");
  EXPECT_EQ(spoken(Term(Rational(10, 3)) / 2),
            "the fraction the fraction 10 over 3 end of fraction over 2 end of fraction");
  EXPECT_EQ(spoken(a / b + a / c), "a over b plus a over c");
}

TEST(Spoken, OfLengths_SaysWhereTheyEndUnlessANameIsAllThereIs) {
  EXPECT_EQ(spoken(norm(at.n)), "the length of n");
  EXPECT_EQ(spoken(norm(at.Q - at.P0) + a), "the length of Q minus P 0 end of length plus a");
  EXPECT_EQ(spoken(norm(at.Q) - at.P0), "the length of Q minus P 0");
  EXPECT_EQ(spoken(norm(Term(-3))), "the magnitude of minus 3");
  EXPECT_EQ(spoken(norm(3 * a)), "the magnitude of 3 a end of magnitude");
  EXPECT_EQ(spoken(norm(at.n) / 3), "the fraction the length of n over 3 end of fraction");
}

TEST(Spoken, OfNegativeNumbers_NeedsNoParentheses) {
  EXPECT_EQ(spoken(Term(2) * -3), "2 times minus 3");
  EXPECT_EQ(spoken(Term(2) - -3), "2 minus minus 3");
}

TEST(Spoken, OfNumbersOfSeveralParts_SaysWhatIsRaisedOrMultiplied) {
  EXPECT_EQ(spoken(power(-3, 2)), "open parenthesis minus 3 close parenthesis squared");
  EXPECT_EQ(spoken(power(Rational(2, 3), 2)), "open parenthesis 2 over 3 close parenthesis squared");
  EXPECT_EQ(spoken(Term(Surd::root(2) + Rational(1)) * 3),
            "open parenthesis 1 plus the square root of 2 end of root close parenthesis times 3");
}

TEST(Spoken, OfNames_SaysThemInWords) {
  EXPECT_EQ(spoken(unknown("λ")), "lambda");
  EXPECT_EQ(spoken(name(perpLetter("u"), std::nullopt)), "u perp");
  EXPECT_EQ(spoken(name(primed(vectorLetter("v")), std::nullopt)), "v prime");
  EXPECT_EQ(spoken(name(word("dist"), std::nullopt)), "distance");
  EXPECT_EQ(spoken(applied(word("cos"), theta, Real(1))), "cosine of theta");
  EXPECT_EQ(spoken(norm(at.n)), "the length of n");
}

TEST(Spoken, OfPowers_SaysSquaredOrThePower) {
  EXPECT_EQ(spoken(power(a, 2)), "a squared");
  EXPECT_EQ(spoken(power(a, 3)), "a to the power 3");
}

TEST(Spoken, OfRowsOfNumbers_CountsThem) {
  EXPECT_EQ(spoken(list({1, 2, -3})), "the triple 1, 2, minus 3,");
  EXPECT_EQ(spoken(list({1, 2})), "the list 1, 2,");
  EXPECT_EQ(spoken(determinant(2, {1, 2, 3, 4})), "the determinant, row 1, 2, row 3, 4,");
  EXPECT_EQ(spoken(determinant(2, {list({1, 2}), list({3, 4})})),
            "the determinant, columns the list 1, 2,, the list 3, 4,,");
}

TEST(Spoken, WithADecimalComma_SaysTheComma) {
  const test::SpokenToIn language(test::withDecimalComma());
  EXPECT_EQ(spoken(Rational(637, 100)), "6,37");
}

TEST(Spoken, OfGreekLetters_HasTheirNamesInTheUsersLanguage) {
  const SpokenToIn nobody(pseudoLanguage());
  for (const GreekLetter &greek : greekLetters)
    EXPECT_EQ(spoken(name(letter(std::string(greek.letter)), std::nullopt)),
              inPseudoLanguage(greek.name.english));
}

} // namespace
} // namespace halfspace
