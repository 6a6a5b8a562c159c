#include "lessons/term/latex.h"

#include "lessons/term/interval.h"
#include "lessons/term/prime.h"
#include "lessons/term/rewrite.h"
#include "lessons/term/written.h"
#include "tests/lessons/construction/precise.h"
#include "tests/lessons/spoken_to_in.h"
#include "tests/lessons/term/term_samples.h"
#include "tests/lessons/term/truth.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

Names namesOfRandomTerms() {
  return {{"p", quantity(Rational(3, 4))},
          {"q", quantity(Rational(-5))},
          {"f(Q)", quantity(Rational(-24))},
          {"\\vec u", quantity(ExactVec3(4, -8, 0))},
          {"\\vec v", quantity(ExactVec3(1, 2, 2))},
          {"P_0", quantity(ExactVec3(-5, 4, 7))},
          {"t", quantity(RandomTerms::unknownValue())}};
}

const NoteTerms at;
const Term t = unknown("t");
const Term a = unknown("a");
const Term b = unknown("b");
const Term c = unknown("c");

TEST(Latex, OfSums_HasParenthesesOnlyBehindAMinusOrASign) {
  EXPECT_EQ(latexOf(a + b - c), "a + b - c");
  EXPECT_EQ(latexOf(a - (b + c)), "a - (b + c)");
  EXPECT_EQ(latexOf(a + -(-b)), "a - (-b)");
  EXPECT_EQ(latexOf(-a - b), "-a - b");
  EXPECT_EQ(latexOf(-(a + b)), "-(a + b)");
  EXPECT_EQ(latexOf(Term(1) + -2), "1 - 2");
  EXPECT_EQ(latexOf(Term(1) - -2), "1 - (-2)");
}

TEST(Latex, OfProducts_HasParenthesesAroundSumsAndNegativeFactors) {
  EXPECT_EQ(latexOf((a + b) * c), "(a + b)\\,c");
  EXPECT_EQ(latexOf(a * -b), "a(-b)");
  EXPECT_EQ(latexOf(Term(-3) * -2), "(-3)\\cdot (-2)");
  EXPECT_EQ(latexOf(2 * (a - 1)), "2(a - 1)");
  EXPECT_EQ(latexOf(2 * (3 * t)), "2(3t)");
  EXPECT_EQ(latexOf(-a * b), "(-a)\\,b");
  EXPECT_EQ(latexOf(-(a * b)), "-a\\,b");
}

TEST(Latex, OfVectorProducts_HoldsSumsTogether) {
  EXPECT_EQ(latexOf(dot(at.n, at.Q - at.P0)), "\\vec n\\cdot (Q - P_0)");
  EXPECT_EQ(latexOf(dot(2 * at.n, at.Q)), "2\\vec n\\cdot Q");
  EXPECT_EQ(latexOf(dot(at.n, 2 * at.Q)), "\\vec n\\cdot (2Q)") << "n times 2 would be no number";
  EXPECT_EQ(latexOf(dot(cross(at.n, at.Q), at.P0)), "(\\vec n\\times Q)\\cdot P_0");
  EXPECT_EQ(latexOf(dot(-at.n, at.Q)), "(-\\vec n)\\cdot Q");
  EXPECT_EQ(latexOf(2 * dot(at.n, at.Q)), "2(\\vec n\\cdot Q)");
}

TEST(Latex, OfPowers_HasParenthesesAroundAllButAtoms) {
  EXPECT_EQ(latexOf(power(a, 2)), "a^2");
  EXPECT_EQ(latexOf(power(a, 12)), "a^{12}");
  EXPECT_EQ(latexOf(power(a + 1, 2)), "(a + 1)^2");
  EXPECT_EQ(latexOf(power(-3, 2)), "(-3)^2");
  EXPECT_EQ(latexOf(power(Rational(2, 3), 2)), "\\left(\\frac{2}{3}\\right)^2");
  EXPECT_EQ(latexOf(power(norm(at.n), 2)), "\\lvert\\vec n\\rvert^2");
  EXPECT_EQ(latexOf(power(power(a, 2), 3)), "(a^2)^3");
  EXPECT_EQ(latexOf(power(applied(word("cos"), name(letter("θ"), std::nullopt), Real(1)), 2)),
            "(\\cos\\theta)^2");
}

TEST(Latex, OfFractions_NeedsNoParentheses) {
  EXPECT_EQ(latexOf((a + b) / (a - b)), "\\frac{a + b}{a - b}");
  EXPECT_EQ(latexOf((a / b) / c), "\\frac{\\tfrac{a}{b}}{c}") << "a fraction in a fraction is small";
  EXPECT_EQ(latexOf(Term(Rational(-10, 3)) / Term(Rational(1, 2))), "\\frac{-10/3}{1/2}")
      << "or flat, of numbers";
  EXPECT_EQ(latexOf(a / b * at.n), "\\frac{a}{b}\\,\\vec n");
  EXPECT_EQ(latexOf(a / b * c), "\\tfrac{a}{b}\\,c") << "before an unknown it is small";
  EXPECT_EQ(latexOf(Rational(-10, 3)), "-\\frac{10}{3}");
  EXPECT_EQ(latexOf(Rational(1, 2) * t + Rational(1, 3)), "\\tfrac{1}{2}t + \\tfrac{1}{3}")
      << "beside one too";
  EXPECT_EQ(latexOf(t - Rational(1, 3)), "t - \\tfrac{1}{3}");
  EXPECT_EQ(latexOf(list({Rational(1, 2), 3})), "\\left(\\tfrac{1}{2},\\,3\\right)");
}

TEST(Latex, OfFlatFractions_HasParenthesesWhereTheyAreNeeded) {
  const auto flat = [](const Term &term) { return latexOf(term, Fractions::Flat); };
  EXPECT_EQ(flat(a / b), "a/b");
  EXPECT_EQ(flat(list({Rational(-1, 2), 3})), "\\left(-1/2,\\,3\\right)");
  EXPECT_EQ(flat(written(Real(Surd::root(6, Rational(1, 6)))).term), "\\sqrt{6}/6");
  EXPECT_EQ(flat((a + b) / (a / b)), "(a + b)/\\left(a/b\\right)");
}

TEST(Latex, OfNames_SpellsGreekLettersAndDecorations) {
  EXPECT_EQ(latexOf(unknown("λ") * unknown("x")), "\\lambda\\,x");
  EXPECT_EQ(latexOf(2 * unknown("λ")), "2\\lambda");
  EXPECT_EQ(latexOf(perpLetter("u")), "\\vec u^{\\perp}");
  EXPECT_EQ(latexOf(vectorLetter("n", "f")), "\\vec n_f");
  EXPECT_EQ(latexOf(primed(vectorLetter("v"))), "\\vec v'");
  EXPECT_EQ(latexOf(letter("P", "12")), "P_{12}");
  EXPECT_EQ(latexOf(word("dist")), "\\operatorname{dist}");
  EXPECT_EQ(latexOf(applied(word("cos"), name(letter("θ"), std::nullopt), Real(1))), "\\cos\\theta");
  EXPECT_EQ(latexOf(applied(word("cos"), name(letter("θ"), std::nullopt), Real(1)) * b), "(\\cos\\theta)\\,b")
      << "else the b would seem to belong to the angle";
}

TEST(Latex, OfDeterminantsAndPermutedProducts_KeepsRowsAndPairs) {
  EXPECT_EQ(latexOf(determinant(2, {a, b, c, 1})), "\\begin{vmatrix}a & b \\\\ c & 1\\end{vmatrix}");
  EXPECT_EQ(latexOf(matrix(2, {a, b})), "\\begin{pmatrix}a & b\\end{pmatrix}");
  EXPECT_EQ(latexOf(permuted(a, b, c, t)), "\\left(a,\\,b\\right) * \\left(c,\\,t\\right)");
}

TEST(Latex, WithADecimalComma_PartsListsBySemicolons) {
  const test::SpokenToIn language(test::withDecimalComma());
  EXPECT_EQ(latexOf(list({Rational(637, 100), 2})), "\\left(6{,}37;\\,2\\right)");
  EXPECT_EQ(relatedLatex(Rational(637, 100)), " = 6{,}37");
}

TEST(Latex, OfTermsThatAreMarks_HasNoMoreThanTheTerms) {
  EXPECT_EQ(latexOf(at.Q - at.P0), "Q - P_0");
  EXPECT_EQ(latexOf(1 - Term(2).marked("two")), "1 - 2");
}

TEST(Latex, OfAChain_HasTheRelationsBetweenItsSides) {
  const Chain chain = withNumbers(at.f == dot(at.n, at.Q - at.P0));
  EXPECT_EQ(latexOf(chain, 2, 4), " = \\left(1,\\,2,\\,2\\right)\\cdot \\left(6,\\,11,\\,1\\right) = 30");
  EXPECT_EQ(latexOf(compared(at.f, 0)), "f(Q) > 0");
  EXPECT_EQ(latexOf(Term(1) == Term(2)), "1 \\neq 2");
}

TEST(RelatedLatex, OfARoundedNumber_IsApproximate) {
  EXPECT_EQ(relatedLatex(10), " = 10");
  EXPECT_EQ(relatedLatex(Rational(1'000'000'007, 3'000'000'019)), " \\approx 0.333333");
}

/// What the value's entries come to at the sample's t.
std::vector<Truth> truthsOf(const TermValue &value) {
  const Truth unknown = truthOf(RandomTerms::unknownValue());
  std::vector<Truth> truths;
  for (const Polynomial &entry : value.entries) {
    const auto middle = [](const Real &number) {
      const Interval within = number.bounds();
      return Truth((Truth(within.low) + Truth(within.high)) / 2);
    };
    Truth truth = middle(entry.constant());
    for (const Polynomial::Summand &summand : entry.summands())
      truth += middle(summand.factor) * mp::pow(unknown, static_cast<int>(summand.monomial.size()));
    truths.push_back(truth);
  }
  return truths;
}

/// The formula's LaTeX, read by another reader, comes to what the term comes to: no parentheses are missing.
void expectReadAsMeant(const Term &term) {
  const std::string latex = latexOf(term);
  const std::vector<Truth> expected = truthsOf(*term->value);
  const Numbers read = calculate(latex, namesOfRandomTerms());
  ASSERT_EQ(read.size(), expected.size()) << latex;
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (mp::isnan(read[i]))
      continue; // the root of what is zero, and for the reader a rounding below it
    const Truth said(read[i].str(110, std::ios_base::scientific));
    const Truth apart = mp::abs(Truth(said - expected[i]));
    EXPECT_LE(apart, Truth("1e-60") * (1 + mp::abs(expected[i]))) << latex;
  }
}

void expectReadAsMeant(std::uint64_t seed, bool withUnknowns) {
  RandomTerms random(seed, withUnknowns);
  int read = 0;
  for (int i = 0; i < 1200 && !testing::Test::HasFailure(); ++i) {
    const Term term = i % 3 == 0 ? random.vector(4) : random.number(4);
    if (!term->value || showsRounded(term))
      continue;
    ++read;
    expectReadAsMeant(term);
    for (Term (*rewriting)(const Term &) : {namesPutIn, numbersPutIn, multipliedOut, calculated})
      if (const Term rewritten = rewriting(term); !showsRounded(rewritten))
        expectReadAsMeant(rewritten);
  }
  EXPECT_GT(read, 500) << "most terms come to something";
}

TEST(Latex, OfAnyTermOfNumbers_IsReadAsItIsMeant) { expectReadAsMeant(3, false); }

TEST(Latex, OfAnyTermWithUnknowns_IsReadAsItIsMeant) { expectReadAsMeant(4, true); }

} // namespace
} // namespace halfspace
