// Fractions around the border of machine words, against Boost's own.
#include "geometry/integer.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace halfspace {
namespace {

/// Not given a negative denominator: Boost 1.74 refuses that.
using Oracle = mp::cpp_rational;

/// A fraction and what it must be.
struct Pair {
  Rational ours;
  Oracle oracle;
};

constexpr std::int64_t leastWord = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t largestWord = std::numeric_limits<std::int64_t>::max();

mp::cpp_int randomBorder(RandomNumbers &random) {
  constexpr std::array<unsigned, 10> powers{0, 1, 31, 32, 53, 61, 62, 63, 64, 127};
  const auto power = powers[static_cast<std::size_t>(random.integer(0, 9))];
  mp::cpp_int value = (mp::cpp_int(1) << power) + random.integer(-3, 3);
  return random.integer(0, 1) == 0 ? value : mp::cpp_int(-value);
}

Rational rationalOf(const mp::cpp_int &value) { return halfspace::rationalOf(Integer(value.str())); }

Pair randomFraction(RandomNumbers &random) {
  const mp::cpp_int p = randomBorder(random);
  mp::cpp_int q = random.integer(0, 2) == 0 ? mp::cpp_int(1) : randomBorder(random);
  if (q == 0)
    q = 1;
  return {rationalOf(p) / rationalOf(q), Oracle(p) / Oracle(q)};
}

bool fitsWord(const mp::cpp_int &value) { return mp::abs(value) <= largestWord; }

/// The same value, in lowest terms over a positive denominator (law (2)), and in words exactly when it fits
/// (law (3)).
testing::AssertionResult isSame(const Rational &ours, const Oracle &oracle) {
  const mp::cpp_int p = mp::numerator(oracle);
  const mp::cpp_int q = mp::denominator(oracle);
  const bool same = toText(ours.numerator()) == p.str() && toText(ours.denominator()) == q.str() &&
                    ours.sign() == p.sign() && ours.isInteger() == (q == 1) &&
                    ours.words().has_value() == (fitsWord(p) && fitsWord(q)) &&
                    toText(ours) == (q == 1 ? p.str() : p.str() + "/" + q.str());
  return same ? testing::AssertionSuccess()
              : testing::AssertionFailure() << toText(ours) << " instead of " << p << "/" << q;
}

TEST(RationalWords, ArithmeticAtTheBorder_IsThatOfBoost) { // law (1)
  RandomNumbers random(141);
  for (int i = 0; i < test::effort(20'000); ++i) {
    const Pair a = randomFraction(random);
    const Pair b = randomFraction(random);
    ASSERT_TRUE(isSame(a.ours, a.oracle));
    ASSERT_TRUE(isSame(a.ours + b.ours, Oracle(a.oracle + b.oracle)));
    ASSERT_TRUE(isSame(a.ours - b.ours, Oracle(a.oracle - b.oracle)));
    ASSERT_TRUE(isSame(a.ours * b.ours, Oracle(a.oracle * b.oracle)));
    ASSERT_TRUE(isSame(-a.ours, Oracle(-a.oracle)));
    ASSERT_TRUE(isSame(abs(a.ours), Oracle(mp::abs(a.oracle))));
    if (b.oracle != 0) {
      ASSERT_TRUE(isSame(a.ours / b.ours, Oracle(a.oracle / b.oracle)));
    }
  }
}

TEST(RationalWords, ComparisonAtTheBorder_IsThatOfBoost) { // law (1)
  RandomNumbers random(142);
  int equal = 0;
  for (int i = 0; i < test::effort(20'000); ++i) {
    const Pair a = randomFraction(random);
    const Pair b = i % 3 == 0 ? Pair{a.ours + 1 - 1, a.oracle} : randomFraction(random);
    equal += a.oracle == b.oracle ? 1 : 0;
    ASSERT_EQ(a.ours == b.ours, a.oracle == b.oracle);
    ASSERT_EQ(a.ours < b.ours, a.oracle < b.oracle) << a.oracle << " " << b.oracle;
    ASSERT_EQ(a.ours > b.ours, a.oracle > b.oracle);
    ASSERT_EQ(a.ours <= b.ours, a.oracle <= b.oracle);
  }
  EXPECT_GT(equal, test::effort(6000));
}

TEST(RationalWords, LongSums_LeaveTheWordsAndComeBack) {
  RandomNumbers random(143);
  for (int i = 0; i < 200; ++i) {
    std::vector<Pair> terms;
    Rational ours = 0;
    Oracle oracle = 0;
    for (int j = 0; j < 20; ++j) {
      terms.push_back(randomFraction(random));
      ours += terms.back().ours;
      oracle += terms.back().oracle;
      ASSERT_TRUE(isSame(ours, oracle));
    }
    for (const Pair &term : terms)
      ours -= term.ours;
    EXPECT_TRUE(isSame(ours, Oracle(0)));
  }
}

TEST(RationalWords, LeastWord_IsNoWordOfOurs) {
  const mp::cpp_int least(leastWord);
  const Rational value(leastWord);
  EXPECT_TRUE(isSame(value, Oracle(least)));
  EXPECT_FALSE(value.words());
  EXPECT_TRUE(isSame(-value, Oracle(-least)));
  EXPECT_TRUE(isSame(value + 1, Oracle(least + 1)));
  EXPECT_TRUE((value + 1).words());
  EXPECT_TRUE(isSame(Rational(-largestWord) - 1, Oracle(least)));
  EXPECT_TRUE(isSame(Rational(leastWord / 2) * 2, Oracle(least)));
  EXPECT_TRUE(isSame(value * -1, Oracle(-least)));
  EXPECT_TRUE(isSame(Rational(1) / value, Oracle(1) / Oracle(least)));
  EXPECT_TRUE(isSame(value / value, Oracle(1)));
  EXPECT_TRUE(isSame(Rational(3, leastWord), Oracle(3) / Oracle(least)));
  EXPECT_TRUE(
      isSame(Rational(std::numeric_limits<std::uint64_t>::max()), Oracle((mp::cpp_int(1) << 64) - 1)));
  EXPECT_EQ(parseFraction(std::to_string(leastWord)), value);
  EXPECT_EQ(toText(value), std::to_string(leastWord));
  EXPECT_EQ(toDouble(value), -0x1p63);
}

TEST(RationalWords, CopiesOfALargeFraction_AreIndependent) {
  const Rational large = powerOfTen(40);
  Rational copy = large;
  copy += 1;
  EXPECT_EQ(large, powerOfTen(40));
  EXPECT_EQ(copy - large, 1);
  copy = copy - large;
  EXPECT_TRUE(copy.words());
}

TEST(ParseDecimal, AnyDigitsAndExponent_IsTheDecimalThatIsSpelled) {
  RandomNumbers random(144);
  const auto digits = [&](int count) {
    std::string text;
    for (int i = 0; i < count; ++i)
      text += static_cast<char>('0' + random.integer(0, 9));
    return text;
  };
  const auto power = [](int exponent) {
    return mp::cpp_int(mp::pow(mp::cpp_int(10), static_cast<unsigned>(exponent)));
  };
  for (int i = 0; i < test::effort(3000); ++i) {
    const std::string whole = "1" + digits(random.integer(0, 40));
    const std::string decimals = digits(random.integer(1, 40));
    const int exponent = random.integer(-400, 400);
    const int shift = exponent - static_cast<int>(decimals.size());
    Oracle expected(mp::cpp_int(whole + decimals));
    expected *= shift >= 0 ? Oracle(power(shift)) : Oracle(1, power(-shift));
    const auto value = parseDecimal("-" + whole + "." + decimals + "e" + std::to_string(exponent));
    ASSERT_TRUE(value);
    ASSERT_TRUE(isSame(*value, Oracle(-expected)));
  }
}

TEST(ParseFraction, Decimals_AreRefusedAndParseDecimalRefusesFractions) {
  for (const char *text : {"0.5", "1e3", "1/2.0", "", "/", "1/", "+1", " 1", "1 ", "- 1", "--1", "NaN"})
    EXPECT_EQ(parseFraction(text), std::nullopt) << text;
  for (const char *text : {"1/2", "", "-", ".", "1.", ".1", "1e", "e1", "0x1", "+1"})
    EXPECT_EQ(parseDecimal(text), std::nullopt) << text;
  EXPECT_EQ(parseFraction("-4/-6"), Rational(2, 3));
  EXPECT_EQ(parseDecimal("-0.25"), Rational(-1, 4));
}

} // namespace
} // namespace halfspace
