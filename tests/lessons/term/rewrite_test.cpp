#include "lessons/term/rewrite.h"

#include "tests/lessons/term/term_samples.h"

#include "lessons/object/kinds/sphere.h"
#include "lessons/term/plain_text.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

const NoteTerms at;
const Term t = unknown("t");
const Term r = name(vectorLetter("r"), ExactVec3(-1, 3, 2));
const Term difference = at.Q - at.P0;

std::string in(Term (*rewriting)(const Term &), const Term &term) { return plainText(rewriting(term)); }

TEST(NamesPutIn, CalculatesNothing) {
  EXPECT_EQ(in(namesPutIn, dot(at.n, difference)), "(1, 2, 2)·((11, 15, 8) − (5, 4, 7))");
  EXPECT_EQ(in(namesPutIn, at.f / norm(at.n)), "30/|(1, 2, 2)|");
  EXPECT_EQ(in(namesPutIn, at.Q + t * r), "(11, 15, 8) + t(−1, 3, 2)") << "an unknown has no number";
}

TEST(NumbersPutIn, CalculatesWhatTheFormulaIsMadeOf) {
  EXPECT_EQ(in(numbersPutIn, dot(at.n, difference)), "(1, 2, 2)·(6, 11, 1)");
  EXPECT_EQ(in(numbersPutIn, at.f / norm(at.n)), "30/3");
  EXPECT_EQ(in(numbersPutIn, dot(-difference, at.n) / dot(r, at.n)), "−30/9");
  EXPECT_EQ(in(numbersPutIn, power(dot(at.n, r), 2) - dot(at.n, at.n) * dot(r, r)), "9² − 9·14");
  EXPECT_EQ(in(numbersPutIn, norm(difference)), "|(6, 11, 1)|");
  EXPECT_EQ(in(numbersPutIn, at.f), "30");
}

TEST(MultipliedOut, WritesDotProductsCoordinateByCoordinate) {
  EXPECT_EQ(in(multipliedOut, dot(at.n, difference)), "1·6 + 2·11 + 2·1");
  EXPECT_EQ(in(multipliedOut, dot(at.n, r)), "1·(−1) + 2·3 + 2·2");
  EXPECT_EQ(in(multipliedOut, root(dot(at.n, at.n))), "√(1·1 + 2·2 + 2·2)");
  EXPECT_EQ(in(multipliedOut, dot(at.n, r) + 5), "1·(−1) + 2·3 + 2·2 + 5") << "one sum";
  EXPECT_EQ(in(multipliedOut, dot(at.n, at.Q + t * r)), "1(11 − t) + 2(15 + 3t) + 2(8 + 2t)");
}

TEST(Distributed, GoesSummandBySummand_AndLeavesOutWhatIsZero) {
  const auto ofPlane = [](const ExactVec3 &normal) {
    return in(distributed, multipliedOut(dot(list({normal.x, normal.y, normal.z}), at.Q + t * r) - 27));
  };
  EXPECT_EQ(ofPlane({1, 2, 2}), "11 − t + 30 + 6t + 16 + 4t − 27");
  EXPECT_EQ(ofPlane({0, 3, 0}), "45 + 9t − 27");
  EXPECT_EQ(ofPlane({-1, 0, 0}), "−11 + t − 27");
  EXPECT_EQ(ofPlane({0, 0, 0}), "−27");
  EXPECT_EQ(in(distributed, multipliedOut(dot(at.n, at.Q))), "11 + 30 + 16");
}

TEST(MultipliedOut, WritesCrossProductsAsDifferencesOfTwoProducts) {
  EXPECT_EQ(in(multipliedOut, cross(at.n, r)), "(2·2 − 2·3, 2·(−1) − 1·2, 1·3 − 2·(−1))");
  EXPECT_EQ(plainText(withProducts(cross(at.n, r))),
            "n×r = (2·2 − 2·3, 2·(−1) − 1·2, 1·3 − 2·(−1)) = (−2, −4, 5)");
  EXPECT_EQ(in(multipliedOut, 2 * cross(at.n, r)), "2(2·2 − 2·3, 2·(−1) − 1·2, 1·3 − 2·(−1))");
}

const Term columns = determinant(3, {at.n, r, name(vectorLetter("c"), ExactVec3(0, 1, 5)).marked("it.c")});

TEST(ColumnsPutIn, OfVectors_WritesEachAsAColumnWithItsMark) {
  EXPECT_EQ(in(columnsPutIn, columns), "det[1 −1 0; 2 3 1; 2 2 5]");
  const Term written = columnsPutIn(columns);
  EXPECT_EQ(written->parts[5]->mark, "it.c");
  EXPECT_EQ(written->parts[3]->mark, at.n->mark);
  EXPECT_EQ(in(columnsPutIn, determinant(2, {1, at.f, 3, 4})), "det[1 30; 3 4]") << "numbers stay";
  EXPECT_EQ(in(numbersPutIn, columns), "det[1 −1 0; 2 3 1; 2 2 5]");
}

TEST(ExpandedAlong, AColumn_TakesItsNumbersTimesWhatIsLeftWithAlternatingSigns) {
  EXPECT_EQ(plainText(expandedAlong(columns, 0)), "1det[3 1; 2 5] − 2det[−1 0; 2 5] + 2det[−1 0; 3 1]");
  EXPECT_EQ(plainText(expandedAlong(columns, 1)), "−(−1)det[2 1; 2 5] + 3det[1 0; 2 5] − 2det[1 0; 2 1]");
  EXPECT_EQ(plainText(expandedAlong(determinant(2, {1, 2, 3, 4}), 0)), "1·4 − 3·2");
  EXPECT_EQ(plainText(expandedAlong(determinant(1, {7}), 0)), "det[7]") << "there is nothing to expand";
  EXPECT_EQ(in(multipliedOut, columns), plainText(expandedAlong(columns, 0)));
  for (const std::size_t column : {0U, 1U, 2U})
    EXPECT_EQ(valueText(expandedAlong(columns, column)), valueText(columns));
  EXPECT_EQ(valueText(columns),
            valueText(dot(cross(columns->parts[0], columns->parts[1]), columns->parts[2])));
}

TEST(Calculated, IsANumberAListOrCollectedByUnknowns) {
  EXPECT_EQ(in(calculated, dot(at.n, difference) / norm(at.n)), "10");
  EXPECT_EQ(in(calculated, at.f / dot(at.n, at.n) * at.n), "(10/3, 20/3, 20/3)");
  EXPECT_EQ(in(calculated, dot(at.n, at.Q + t * r) - 27), "9t + 30");
  EXPECT_EQ(in(calculated, 5 - t * t - t), "−t² − t + 5");
  EXPECT_EQ(in(calculated, t * unknown("x") * 3), "3t x");
  EXPECT_EQ(in(calculated, t - t), "0");
  EXPECT_EQ(in(calculated, 2 * t), "2t");
}

TEST(Calculated, OfATermWithoutAValue_StaysAsItIs) {
  EXPECT_EQ(in(calculated, dot(at.n, r) / Term(0)), "(n·r)/0");
}

TEST(MultipleOf, HasItsSignInFront) {
  EXPECT_EQ(plainText(multipleOf(Term(-2) / 3, r)), "−(2/3) r");
  EXPECT_EQ(plainText(multipleOf(Term(4) / 2, r)), "2r");
  EXPECT_EQ(plainText(multipleOf(t, r)), "t r");
  EXPECT_EQ(valueText(multipleOf(Term(-2) / 3, r)), "(2/3, -2, -4/3)");
}

TEST(Rewriting, OfCoordinates_RemembersWhereTheyStand) {
  const Term numbers = namesPutIn(at.Q);
  ASSERT_EQ(numbers->parts.size(), 3U);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(numbers->parts[static_cast<std::size_t>(i)]->source, (CoordinateSource{"Q", 0, i}));
  const Term products = multipliedOut(dot(at.n, at.P0));
  ASSERT_EQ(products->parts.size(), 3U);
  EXPECT_EQ(products->parts[1]->parts[0]->source, (CoordinateSource{"E", 1, 1}));
  EXPECT_EQ(products->parts[1]->parts[1]->source, (CoordinateSource{"E", 0, 1}));
}

TEST(Rewriting, OfACoordinateThatIsOneNumber_RemembersWhereItStands) {
  const Given<SphereObject> sphere{"B", letter("B"), {letter("c"), letter("R")}, {{1, 2, 3}, 5}};
  EXPECT_EQ(namesPutIn(termsOf(sphere).R)->source, (CoordinateSource{"B", 1, 0}));
}

TEST(Rewriting, OfWhatIsCalculated_HasNoSourceButAnOrigin) {
  const Term numbers = calculated(difference);
  ASSERT_EQ(numbers->parts.size(), 3U);
  for (const Term &number : numbers->parts) {
    EXPECT_FALSE(number->source);
    ASSERT_TRUE(number->origin);
    EXPECT_EQ(plainText(*number->origin), "Q − P₀");
  }
  const Term length = numbersPutIn(at.f / norm(at.n))->parts[1];
  ASSERT_TRUE(length->origin);
  EXPECT_EQ(plainText(*length->origin), "|n|");
}

/// No step between a formula and its result changes what it comes to.
void expectValuesKept(std::uint64_t seed, bool withUnknowns) {
  RandomTerms random(seed, withUnknowns);
  int exact = 0;
  for (int i = 0; i < 600; ++i) {
    const Term term = i % 3 == 0 ? random.vector(3) : random.number(3);
    for (Term (*rewriting)(const Term &) : {namesPutIn, numbersPutIn, multipliedOut, calculated}) {
      const Term rewritten = rewriting(term);
      ASSERT_EQ(rewritten->value.has_value(), term->value.has_value())
          << plainText(term) << " became " << plainText(rewritten);
      if (!term->value)
        continue;
      const auto same = areEqual(*term->value, *rewritten->value);
      EXPECT_NE(same, false) << plainText(term) << " became " << plainText(rewritten);
      exact += same == true ? 1 : 0;
    }
  }
  EXPECT_GT(exact, 1000) << "most terms are exact";
}

TEST(Rewriting, OfAnyNumbers_KeepsTheValue) { expectValuesKept(1, false); }

TEST(Rewriting, OfAnyUnknowns_KeepsTheValue) { expectValuesKept(2, true); }

TEST(Rewriting, ANameOfOneCoordinate_KeepsWhichItIs) {
  TermNode second = *given(letter("Q", "y"), {1, 2, 3}, "Q", 0);
  second.value = Rational(2);
  second.source->component = 1;
  const Term number = calculated(Term(std::make_shared<const TermNode>(second)));
  EXPECT_EQ(plainText(number), "2");
  EXPECT_EQ(number->source, (CoordinateSource{"Q", 0, 1}));
}

} // namespace
} // namespace halfspace
