#include "lessons/term/slips.h"

#include "tests/lessons/term/term_samples.h"

#include "lessons/lesson/usual_mistakes.h"
#include "lessons/term/plain_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

using namespace test;

using Texts = std::vector<std::string>;

const NoteTerms at;
const Term difference = at.Q - at.P0;

/// What the term becomes by this slip, with what that comes to.
Texts by(Slip slip, const Term &term) {
  Texts texts;
  for (const WrongWay &way : wrongWays(term))
    if (way.slip == slip)
      texts.push_back(plainText(way.whole) + " = " + valueText(way.whole));
  return texts;
}

TEST(WrongWays, OfADifference_ReverseItAddOrDropAPart) {
  const Term f = dot(at.n, difference);
  EXPECT_EQ(by(Slip::ReversedDifference, f), Texts{"n·(P₀ − Q) = -30"});
  EXPECT_EQ(by(Slip::AddedInstead, f), Texts{"n·(Q + P₀) = 84"});
  EXPECT_EQ(by(Slip::DroppedPart, f), (Texts{"n·(−P₀) = -27", "n·Q = 57"}));
}

TEST(WrongWays, OfALongerSum_DropOnePartEach) {
  EXPECT_EQ(by(Slip::DroppedPart, sum({1, 2, 4})), (Texts{"2 + 4 = 6", "1 + 4 = 5", "1 + 2 = 3"}));
  EXPECT_EQ(by(Slip::ReversedDifference, sum({1, 2, 4})), Texts{});
}

TEST(WrongWays, OfAFraction_TurnItOrLeaveOutTheDivisor) {
  EXPECT_EQ(by(Slip::UpsideDown, at.f / norm(at.n)), Texts{"|n|/f(Q) = 1/10"});
  EXPECT_EQ(by(Slip::Undivided, at.f / norm(at.n)), Texts{"f(Q) = 30"});
  EXPECT_EQ(by(Slip::RootOfDivisor, at.f / norm(at.n)), Texts{}) << "a length is no square";
  EXPECT_EQ(by(Slip::RootOfDivisor, at.f / dot(at.n, at.n)), Texts{"f(Q)/(√(n·n)) = 10"});
}

TEST(WrongWays, OfRootsAndSquares_LeaveThemOut) {
  EXPECT_EQ(by(Slip::NoRoot, norm(at.n)), Texts{"n·n = 9"});
  EXPECT_EQ(by(Slip::NoRoot, root(dot(at.n, at.n))), Texts{"n·n = 9"});
  EXPECT_EQ(by(Slip::NotSquared, power(at.f, 2) - 1), Texts{"f(Q) − 1 = 29"});
}

TEST(WrongWays, OfNegativeNumbers_LoseTheirSign) {
  EXPECT_EQ(by(Slip::LostSign, Term(2) * -3 + 4), Texts{"2(−(−3)) + 4 = 10"});
  EXPECT_EQ(by(Slip::LostSign, -at.f), Texts{"f(Q) = 30"});
  EXPECT_EQ(by(Slip::LostSign, Term(2) * 3), Texts{});
}

TEST(WrongWays, OfNames_TakeOneForAnotherOfItsKind) {
  EXPECT_EQ(by(Slip::OtherName, dot(at.Q, at.n) * at.f), (Texts{"(n·n) f(Q) = 270", "(Q·Q) f(Q) = 12300"}))
      << "a vector is not taken for a number";
}

TEST(WrongWays, OfATermInside_LeaveTheRestAsItIs) {
  const Term term = dot(difference, at.n) / dot(at.n, at.n) + 1;
  const auto ways = wrongWays(term);
  ASSERT_FALSE(ways.empty());
  const auto found = std::find_if(ways.begin(), ways.end(),
                                  [](const WrongWay &way) { return way.slip == Slip::ReversedDifference; });
  ASSERT_NE(found, ways.end());
  EXPECT_EQ(plainText(found->whole), "((P₀ − Q)·n)/(n·n) + 1");
  EXPECT_EQ(plainText(found->right), "Q − P₀");
  EXPECT_EQ(plainText(found->instead), "P₀ − Q");
}

TEST(WrongWays, OfATermWithoutAnything_AreNone) { EXPECT_TRUE(wrongWays(Term(3)).empty()); }

TEST(WrongWays, OfAnyTerm_ComeInTheOrderOfTheSlips) {
  RandomTerms random(6);
  for (int i = 0; i < 50; ++i) {
    const auto ways = wrongWays(random.number(3));
    EXPECT_TRUE(std::is_sorted(ways.begin(), ways.end(),
                               [](const WrongWay &a, const WrongWay &b) { return a.slip < b.slip; }));
  }
}

/// The sentences of the mistakes that come to this number.
Texts sentencesFor(const Chain &chain, const Rational &answer) {
  Texts sentences;
  for (const WrongTerm &mistake : usualMistakes(chain))
    if (const Real *number = numberOf(mistake.wrong); number && areEqual(*number, answer) == true)
      sentences.push_back(mistake.sentence);
  return sentences;
}

TEST(UsualMistakes, OfADotProduct_AreFoundInItsLettersAndMultipliedOut) {
  const Chain f = at.f == dot(at.n, difference);
  EXPECT_EQ(sentencesFor(f, -30),
            Texts{"{answer} comes from P₀ − Q. Here it must be Q − P₀: the difference goes the other way."});
  EXPECT_EQ(sentencesFor(f, 57), Texts{"{answer} comes from Q. Here it must be Q − P₀: P₀ is left out."});
  EXPECT_EQ(sentencesFor(f, 8),
            Texts{"{answer} comes from 1·6 + 2·1. Here it must be 1·6 + 2·11 + 2·1: 2·11 is left out."});
}

TEST(UsualMistakes, OfAChainWithNumbers_AreThoseOfItsLastSymbols) {
  const Chain f = at.f == dot(at.n, difference);
  EXPECT_EQ(usualMistakes(f).size(), usualMistakes(f.then(30)).size());
}

TEST(UsualMistakes, HaveTheirAnswerInEverySentence) {
  RandomTerms random(7);
  for (int i = 0; i < 50; ++i)
    for (const WrongTerm &mistake : usualMistakes(random.number(3))) {
      EXPECT_TRUE(mistake.sentence.starts_with("{answer} ")) << mistake.sentence;
    }
}

} // namespace
} // namespace halfspace
