// Chains, slips and rewritings of random terms: what holds of every one of them.
#include "lessons/term/chain.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/term/slips.h"
#include "lessons/term/spoken.h"
#include "lessons/term/written.h"
#include "lessons/text.h"
#include "tests/geometry/random_numbers.h"
#include "tests/lessons/term/term_samples.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

TEST(Compared, RandomNumbers_AreInTheOrderOfTheirValues) {
  RandomNumbers random(2);
  for (int i = 0; i < 200; ++i) {
    const Rational a = random.rational(2);
    const Rational b = i % 4 == 0 ? a : random.rational(2);
    const Relation expected = a < b ? Relation::Less : a == b ? Relation::Equal : Relation::Greater;
    EXPECT_EQ(compared(a, b).relations().at(0), expected) << a << " and " << b;
    EXPECT_FALSE(compared(a, b).isIdentity());
  }
}

TEST(Chain, OfARandomTermWithItsNumbers_NeverClaimsWhatDoesNotHold) {
  RandomTerms random(31);
  int equal = 0;
  for (int i = 0; i < 300; ++i) {
    const Term term = i % 3 == 0 ? random.vector(3) : random.number(3);
    if (!term->value)
      continue;
    for (const Chain &chain : {withNumbers(term), withProducts(term), withResult(term)}) {
      bool approximate = false;
      for (const Relation relation : chain.relations()) {
        EXPECT_TRUE(relation == Relation::Equal || relation == Relation::Approximately) << plainText(chain);
        EXPECT_FALSE(approximate && relation == Relation::Equal) << plainText(chain) << ": exact again";
        approximate = relation == Relation::Approximately;
        equal += approximate ? 0 : 1;
      }
      for (std::size_t side = 1; side < chain.sides().size(); ++side)
        EXPECT_FALSE(readAlike(chain.sides()[side - 1], chain.sides()[side])) << plainText(chain);
      EXPECT_TRUE(readAlike(chain.formula(), term)) << "what was calculated is no formula";
    }
  }
  EXPECT_GT(equal, 300);
}

TEST(ChainFormula, OfEachClaim_IsWhereItsResultComesFrom) {
  const NoteTerms at;
  const Term left = dot(at.n, at.Q) - 27;
  EXPECT_TRUE(readAlike(withResult(at.f == left).formula(), left)) << "the last side in symbols";
  EXPECT_TRUE(readAlike(condition(Chain(0).then(left).then(calculated(left))).formula(), left));
  EXPECT_TRUE(readAlike(condition(withResult(0 == left)).formula(), left));
  EXPECT_TRUE(readAlike(withResult(compared(at.f, 9)).formula(), at.f)) << "what is compared";
}

TEST(WrongWays, OfRandomTerms_PutInsteadWhatComesToAnotherTermOnly) {
  RandomTerms random(13);
  int changed = 0;
  for (int i = 0; i < 100; ++i) {
    const Term term = random.number(3);
    for (const WrongWay &way : wrongWays(term)) {
      EXPECT_FALSE(readAlike(way.right, way.instead)) << plainText(term) << ": " << plainText(way.right);
      EXPECT_FALSE(readAlike(term, way.whole)) << plainText(term) << " unchanged";
      if (!term->value || !way.right->value || !way.instead->value)
        continue;
      if (areEqual(*way.right->value, *way.instead->value) == true) {
        ASSERT_TRUE(way.whole->value) << plainText(way.whole);
        EXPECT_NE(areEqual(*way.whole->value, *term->value), false) << plainText(way.whole);
      } else {
        ++changed;
      }
    }
  }
  EXPECT_GT(changed, 200) << "most slips are seen in the number";
}

class LongSums : public testing::TestWithParam<int> {};

TEST_P(LongSums, OfPositiveParts_LoseEachPartOnceAndTurnEachButTheFirst) {
  std::vector<Term> parts;
  Rational whole = 0;
  for (int i = 0; i < GetParam(); ++i) {
    parts.emplace_back(1 << i);
    whole = whole + (1 << i);
  }
  std::vector<Term> expected;
  for (int i = 1; i < GetParam(); ++i)
    expected.emplace_back(Rational(whole - 2 * (1 << i)));
  for (int i = 0; i < GetParam(); ++i)
    expected.emplace_back(Rational(whole - (1 << i)));
  std::vector<Term> found;
  for (const Slip slip : {Slip::SubtractedInstead, Slip::DroppedPart})
    for (const WrongWay &way : wrongWays(sum(parts)))
      if (way.slip == slip)
        found.push_back(way.whole);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_EQ(valueText(found[i]), valueText(expected[i]));
}

INSTANTIATE_TEST_SUITE_P(Parts, LongSums, testing::Values(2, 3, 5));

TEST(Written, OfRandomFractions_ReadsBackAsTheNumberOrRoundsItsSixthDigit) {
  RandomNumbers random(17);
  int exact = 0;
  for (int i = 0; i < 500; ++i) {
    const int scale = 1 << random.integer(0, 30);
    const Rational value = Rational(random.integer(-scale, scale)) * random.rational(999) /
                           random.integer(1, 1 << random.integer(0, 30));
    const WrittenNumber number = written(value);
    const std::string text = replacedAll(plainText(number.term), "−", "-");
    exact += number.exact ? 1 : 0;
    if (number.exact) {
      EXPECT_EQ(parseRational(text), value) << text;
      EXPECT_LE(text.size(), longestExactForm + 1) << text;
    } else if (const auto shown = parseRational(text)) {
      EXPECT_LE(abs(Rational(*shown - value)), Rational(abs(value) / 199'999)) << text;
    }
  }
  EXPECT_GT(exact, 50);
  EXPECT_LT(exact, 450) << "some are rounded";
}

std::size_t countOf(const std::string &text, const std::string &words) {
  std::size_t count = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
    ++count;
  return count;
}

TEST(Spoken, OfRandomTerms_EndsWhatItBegins) {
  RandomTerms random(23, true);
  std::size_t fractions = 0;
  for (int i = 0; i < 300; ++i) {
    const std::string text = spoken(random.number(4));
    EXPECT_EQ(countOf(text, "open parenthesis"), countOf(text, "close parenthesis")) << text;
    EXPECT_EQ(countOf(text, "the fraction"), countOf(text, "end of fraction")) << text;
    EXPECT_GE(countOf(text, "the square root of"), countOf(text, "end of root")) << text;
    EXPECT_EQ(text.find("  "), std::string::npos) << text;
    EXPECT_EQ(text, trimmed(text));
    fractions += countOf(text, "the fraction");
  }
  EXPECT_GT(fractions, 50U);
}

} // namespace
} // namespace halfspace
