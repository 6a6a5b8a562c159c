#include "lessons/term/chain.h"

#include "tests/lessons/term/term_samples.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

const NoteTerms at;
const Term t = unknown("t");
/// 1/3 as a decimal, rounded, because its digits would be too many.
const Term longNumber = Rational(1'000'000'007, 3'000'000'019);
const Term x = name(letter("x"), Rational(1'000'000'007, 3'000'000'019));

TEST(Chain, OfExactSides_IsEqual) {
  EXPECT_EQ(plainText(withNumbers(at.f == dot(at.n, at.Q - at.P0))),
            "f(Q) = n·(Q − P₀) = (1, 2, 2)·(6, 11, 1) = 30");
}

TEST(Chain, FromTheFirstRoundedNumberOn_IsApproximate) {
  EXPECT_EQ(plainText((x == x + 0).then(longNumber).then(longNumber + 0)),
            "x = x + 0 ≈ 0.333333 ≈ 0.333333 + 0");
  EXPECT_EQ((longNumber == x).relations().at(0), Relation::Approximately) << "a first side counts too";
}

TEST(Chain, WithAValueBetweenBounds_IsApproximate) {
  const Term nested = root(root(2) + 1);
  const Chain chain = withResult(name(letter("s"), *nested->value) == nested);
  EXPECT_EQ(plainText(chain), "s ≈ √(√2 + 1) ≈ 1.55377") << "equality of the first two is not known";
}

TEST(Chain, OfSumsOfRoots_IsEqualWhereTheyAreTheSame) {
  const Term sum = root(2) + root(3);
  const Chain chain = withResult(name(letter("s"), *sum->value) == sum);
  EXPECT_EQ(plainText(chain), "s = √2 + √3 ≈ 3.14626");
}

TEST(Chain, OfSidesThatDiffer_SaysSo) {
  EXPECT_EQ(plainText(at.f == dot(at.n, at.Q)), "f(Q) ≠ n·Q");
  EXPECT_EQ((Term(1) == Term(1) / 0).relations().at(0), Relation::Unequal) << "a side without a value";
  EXPECT_EQ(((x == longNumber) == 5).relations().at(1), Relation::Unequal) << "rounding excuses nothing";
  EXPECT_EQ((at.n == at.f).relations().at(0), Relation::Unequal);
}

TEST(Chain, WithOneFalseSide_IsFalseThereOnly) {
  const Chain chain = ((Term(2) == Term(1) + 1) == 3) == Term(4) - 2;
  EXPECT_EQ(chain.relations(), (std::vector{Relation::Equal, Relation::Unequal, Relation::Equal}));
}

TEST(Condition, IsDemandedOfItsFirstSideAndTrueOfTheOthers) {
  const Term left = dot(at.n, at.Q + t * at.n) - 27;
  const Chain chain = condition((0 == left).then(calculated(left)));
  EXPECT_EQ(plainText(chain), "0 = n·(Q + t n) − 27 = 9t + 30");
  EXPECT_EQ(condition((0 == left) == left + 1).relations(),
            (std::vector{Relation::Equal, Relation::Unequal}));
}

TEST(Condition, WithoutAnUnknownThatCouldFulfilIt_IsShownAsFalse) {
  EXPECT_EQ(plainText(condition(Term(0) == t * 0 + 18)), "0 ≠ t 0 + 18");
  EXPECT_EQ(condition(Term(0) == t * 0).relations(), std::vector{Relation::Equal});
  EXPECT_EQ(condition(Term(0) == t + 18).relations(), std::vector{Relation::Equal});
}

TEST(Condition, AsADemand_TellsNothingOfWhetherItCanBeFulfilled) {
  const Chain chain = condition((Term(0) == t * 0 + 18).then(20));
  EXPECT_EQ(chain.asDemand().relations(), (std::vector{Relation::Equal, Relation::Unequal}));
  EXPECT_EQ(plainText((at.n == 1).asDemand()), plainText(at.n == 1)) << "no condition";
}

TEST(Compared, WritesTheRelationThatHolds) {
  EXPECT_EQ(plainText(compared(at.f, 0)), "f(Q) > 0");
  EXPECT_EQ(plainText(compared(-1, 0)), "−1 < 0");
  EXPECT_EQ(plainText(compared(at.f, 30)), "f(Q) = 30");
  EXPECT_EQ(plainText(compared(root(2) + root(3), 3)), "√2 + √3 > 3");
  EXPECT_EQ(compared(at.n, 0).relations().at(0), Relation::Unequal) << "a vector has no order";
}

TEST(Compared, ThatGoesOn_ComparesTheFirstTwoAndEqualsFromThereOn) {
  EXPECT_EQ(plainText(withResult(compared(at.f, dot(at.n, at.n)))), "f(Q) > n·n = 9");
  EXPECT_EQ(compared(at.f, 9).then(8).relations(), (std::vector{Relation::Greater, Relation::Unequal}));
}

TEST(InOrder, ComparesEachWithTheOneBefore) {
  EXPECT_EQ(plainText(inOrder({-1, 0, at.f, at.f, 40})), "−1 < 0 < f(Q) = f(Q) < 40");
}

TEST(ChainThen, OfASideThatReadsTheSame_LeavesItOut) {
  EXPECT_EQ(plainText(withNumbers(name(letter("a"), Rational(2)) == Term(2))), "a = 2");
  EXPECT_EQ(plainText(withProducts(norm(at.n) == root(dot(at.n, at.n)))),
            "|n| = √(n·n) = √(1·1 + 2·2 + 2·2) = 3");
}

TEST(ChainThen, OfACalculatedSideThatReadsTheSame_KeepsTheLaterOrigin) {
  const Term first = number(Rational(3), at.P0);
  const Term second = number(Rational(3), at.n);
  const Chain chain = Chain(at.f).then(first).then(second);
  ASSERT_EQ(chain.sides().size(), 2U);
  EXPECT_EQ(plainText(*chain.last()->origin), "n");
}

TEST(ChainSymbolic, CountsTheSidesBeforeTheCalculatedOnes) {
  const Chain chain = withNumbers(at.f == dot(at.n, at.Q - at.P0));
  EXPECT_EQ(chain.symbolic(), 2U);
  EXPECT_EQ(chain.sides().size(), 4U);
  EXPECT_EQ(Chain(at.f).symbolic(), 1U);
}

} // namespace
} // namespace halfspace
