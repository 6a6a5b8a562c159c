#include "geometry/integer.h"
#include "geometry/rational.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

namespace halfspace {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double smallest = std::numeric_limits<double>::denorm_min();

std::string randomDecimal(RandomNumbers &random) {
  std::string text = random.integer(0, 1) == 0 ? "" : "-";
  text += static_cast<char>('1' + random.integer(0, 8));
  if (const int decimals = random.integer(0, 40); decimals > 0) {
    text += '.';
    for (int i = 0; i < decimals; ++i)
      text += static_cast<char>('0' + random.integer(0, 9));
  }
  return text + "e" + std::to_string(random.integer(-345, 312));
}

TEST(ParseRational, DecimalsAndFractions_AreTakenAsExactlyWhatTheySpell) {
  EXPECT_EQ(parseRational("0"), Rational(0));
  EXPECT_EQ(parseRational("-0"), Rational(0));
  EXPECT_EQ(parseRational("15"), Rational(15));
  EXPECT_EQ(parseRational("0.1"), Rational(1, 10));
  EXPECT_EQ(parseRational("-1.50"), Rational(-3, 2));
  EXPECT_EQ(parseRational("1e-3"), Rational(1, 1000));
  EXPECT_EQ(parseRational("2E+3"), Rational(2000));
  EXPECT_EQ(parseRational("12.5e1"), Rational(125));
  EXPECT_EQ(parseRational("-10/3"), Rational(-10, 3));
  EXPECT_EQ(parseRational("6/-4"), Rational(-3, 2));
  EXPECT_EQ(parseRational("-6/-4"), Rational(3, 2));
}

TEST(ParseRational, LeadingZeros_AreNoOctalNumbers) {
  EXPECT_EQ(parseRational("010"), Rational(10));
  EXPECT_EQ(parseRational("08/010"), Rational(4, 5));
  EXPECT_EQ(parseRational("1e0002"), Rational(100));
}

TEST(ParseRational, AnyOtherText_IsRefused) {
  for (const char *text :
       {"",    "-",    "+1",    "--1",   " 1",    "1 ",    "1 /2",  "NaN",   "nan", "inf",  "Infinity",
        "0x1", "1.",   ".5",    "-.5",   "1e",    "1e+",   "e5",    "1,5",   "1_0", "1/",   "/2",
        "1/+", "1/+2", "1/2/3", "1.5/2", "1/2.5", "1e2/3", "1/2e3", "1.2.3", "½",   "1/--2"})
    EXPECT_EQ(parseRational(text), std::nullopt) << '"' << text << '"';
}

TEST(ParseRational, ZeroDenominator_IsRefused) {
  EXPECT_EQ(parseRational("1/0"), std::nullopt);
  EXPECT_EQ(parseRational("0/-00"), std::nullopt);
}

TEST(ParseRational, AtItsLimits_TakesTheLastAndRefusesTheNext) {
  const std::string most(maxDigits, '1');
  const std::string half(maxDigits / 2, '0');
  EXPECT_TRUE(parseRational(most));
  EXPECT_TRUE(parseRational("-" + most + "/" + most));
  EXPECT_TRUE(parseRational(half + "." + half));
  EXPECT_EQ(parseRational(most + "1"), std::nullopt);
  EXPECT_EQ(parseRational("1/" + most + "1"), std::nullopt);
  EXPECT_EQ(parseRational(most + "1/1"), std::nullopt);
  EXPECT_EQ(parseRational(half + ".0" + half), std::nullopt);
  EXPECT_EQ(parseRational("1e400"), powerOfTen(400));
  EXPECT_EQ(parseRational("1e-400"), powerOfTen(-400));
  EXPECT_EQ(parseRational("1e401"), std::nullopt);
  EXPECT_EQ(parseRational("1e-401"), std::nullopt);
  EXPECT_EQ(parseRational("1e99999999999999999999"), std::nullopt);
}

TEST(ToText, Fraction_IsInLowestTermsWithoutDenominatorOne) {
  EXPECT_EQ(toText(Rational(0)), "0");
  EXPECT_EQ(toText(Rational(-20, 6)), "-10/3");
  EXPECT_EQ(toText(Rational(14, 7)), "2");
}

TEST(ToText, ReadBack_GivesTheSameFraction) { // law (1) of parseRational
  RandomNumbers random(1);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Rational value = random.rational(1000000);
    EXPECT_EQ(parseRational(toText(value)), value);
    const Rational limit = powerOfTen(static_cast<int>(maxDigits));
    const Rational large = (limit - random.integer(1, 999)) / (limit - random.integer(1, 999));
    EXPECT_EQ(parseRational(toText(large)), large);
    EXPECT_EQ(parseRational(toText(-large)), -large);
  }
}

TEST(ToDouble, DecimalsOfEverySize_AreRoundedAsTheCLibraryDoes) {
  RandomNumbers random(2);
  for (int i = 0; i < test::effort(20000); ++i) {
    const std::string text = randomDecimal(random);
    const auto value = parseRational(text);
    ASSERT_TRUE(value) << text;
    EXPECT_EQ(toDouble(*value), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ToDouble, LargerFraction_IsNoSmallerDoubleAndTheNegativeOneIsTheNegative) {
  RandomNumbers random(206);
  for (int i = 0; i < test::effort(5000); ++i) {
    const Rational x = random.rational() * powerOfTen(random.integer(-330, 315));
    const Rational step = abs(x) * powerOfTen(-random.integer(14, 18)) * random.integer(0, 3);
    EXPECT_EQ(toDouble(Rational(-x)), -toDouble(x));      // law (1)
    EXPECT_LE(toDouble(x), toDouble(Rational(x + step))); // law (2)
  }
}

TEST(ToDouble, AnyDouble_IsItself) { // law (3)
  RandomNumbers random(3);
  for (int i = 0; i < test::effort(10000); ++i) {
    const double value = random.anyDouble();
    EXPECT_EQ(toDouble(exactly(value)), value);
  }
  for (const double value : {smallest, -smallest, largest, -largest, std::numeric_limits<double>::min()})
    EXPECT_EQ(toDouble(exactly(value)), value);
}

TEST(ToDouble, HalfwayBetweenTwoDoubles_TakesTheEvenOne) {
  RandomNumbers random(4);
  for (int i = 0; i < test::effort(10000); ++i) {
    const double below = std::abs(random.anyDouble());
    const double above = std::nextafter(below, infinity);
    if (above == infinity)
      continue;
    const Rational middle = (exactly(below) + exactly(above)) / 2;
    const Rational hair = (exactly(above) - exactly(below)) * powerOfTen(-30);
    // Of two neighbours the even one is a whole number of twice their distance.
    const Rational steps = exactly(below) / (2 * (exactly(above) - exactly(below)));
    const double even = steps.denominator() == 1 ? below : above;
    EXPECT_EQ(toDouble(middle), even);
    EXPECT_EQ(toDouble(Rational(-middle)), -even);
    EXPECT_EQ(toDouble(Rational(middle - hair)), below);
    EXPECT_EQ(toDouble(Rational(middle + hair)), above);
  }
}

TEST(ToDouble, AtTheSmallestDouble_HalfIsZeroAndAnythingMoreIsNot) {
  const Rational half = exactly(smallest) / 2;
  EXPECT_EQ(toDouble(half), 0);
  EXPECT_EQ(toDouble(Rational(half * Rational(1000001, 1000000))), smallest);
  EXPECT_EQ(toDouble(Rational(half * Rational(-1000001, 1000000))), -smallest);
  EXPECT_EQ(toDouble(Rational(half * 3)), 2 * smallest);
  EXPECT_EQ(toDouble(powerOfTen(-400)), 0);
}

TEST(ToDouble, BeyondTheLargestDouble_IsInfinite) {
  const Rational halfStep = exactly(largest) / ((std::int64_t{1} << 54) - 2);
  const Rational edge = exactly(largest) + halfStep;
  EXPECT_EQ(toDouble(edge), infinity);
  EXPECT_EQ(toDouble(Rational(-edge)), -infinity);
  EXPECT_EQ(toDouble(Rational(edge * (1 - powerOfTen(-40)))), largest);
  EXPECT_EQ(toDouble(powerOfTen(400)), infinity);
}

TEST(NearestDouble, AnyFractionAndExponent_IsTheDoubleOfTheirProduct) { // law (1)
  RandomNumbers random(207);
  for (int i = 0; i < test::effort(3000); ++i) {
    const Rational value = random.rational() * powerOfTen(random.integer(-30, 30));
    const int exponent = random.integer(-1200, 1200);
    const Rational power = rationalOf(Integer(1) << std::abs(exponent));
    EXPECT_EQ(nearestDouble(numeratorOf(value), denominatorOf(value), exponent),
              toDouble(exponent < 0 ? Rational(value / power) : Rational(value * power)));
  }
}

TEST(PowerOfTen, AnyTwoExponents_MultiplyToTheirSums) { // law (1)
  EXPECT_EQ(powerOfTen(0), 1);
  for (int a = -maxExponent; a < maxExponent; ++a)
    EXPECT_EQ(powerOfTen(a + 1), powerOfTen(a) * 10);
  for (int a = -40; a <= 40; ++a) {
    for (int b = -40; b <= 40; ++b)
      EXPECT_EQ(powerOfTen(a) * powerOfTen(b), powerOfTen(a + b));
  }
}

TEST(NearestDouble, ScaledByAPowerOfTwo_IsTheScaledFraction) {
  EXPECT_EQ(nearestDouble(3, 4, 10), 768);
  EXPECT_EQ(nearestDouble(-3, 4, -1074), -smallest);
  EXPECT_EQ(nearestDouble(0, 7, 5000), 0);
}

TEST(RoundToMultiple, Halves_GoUp) {
  EXPECT_EQ(roundToMultiple(Rational(1, 2), 1), 1);
  EXPECT_EQ(roundToMultiple(Rational(-1, 2), 1), 0);
  EXPECT_EQ(roundToMultiple(Rational(-3, 2), 1), -1);
  EXPECT_EQ(roundToMultiple(Rational(3, 8), Rational(1, 4)), Rational(1, 2));
  EXPECT_EQ(roundUpToMultiple(Rational(1, 3), Rational(1, 4)), Rational(1, 2));
  EXPECT_EQ(roundUpToMultiple(Rational(-1, 3), Rational(1, 4)), Rational(-1, 4));
  EXPECT_EQ(roundUpToMultiple(Rational(3, 4), Rational(1, 4)), Rational(3, 4));
  EXPECT_EQ(roundToMultiple(2.5, 1), 3);
  EXPECT_EQ(roundToMultiple(-2.5, 1), -2);
}

TEST(RoundToMultiple, AnyValueAndStep_GivesTheNearestMultiple) {
  RandomNumbers random(5);
  for (int i = 0; i < test::effort(3000); ++i) {
    const Rational value = random.rational(1000);
    const Rational step = abs(random.nonZeroRational());
    const Rational rounded = roundToMultiple(value, step);
    EXPECT_EQ((rounded / step).denominator(), 1); // law (1)
    EXPECT_LE(abs(rounded - value), step / 2);
    EXPECT_EQ(roundToMultiple(rounded, step), rounded); // law (2)
    const Rational shift = step * random.integer(-9, 9);
    EXPECT_EQ(roundToMultiple(Rational(value + shift), step), rounded + shift); // law (3)
  }
}

TEST(RoundToMultiple, Double_IsTakenAtItsExactValue) {
  RandomNumbers random(6);
  for (int i = 0; i < test::effort(3000); ++i) {
    const double value = random.anyDouble();
    EXPECT_EQ(roundToMultiple(value, Rational(1, 10)), roundToMultiple(exactly(value), Rational(1, 10)));
  }
  // 0.15 as a double is a little less than 15/100.
  EXPECT_EQ(roundToMultiple(0.15, Rational(1, 10)), Rational(1, 10));
  EXPECT_EQ(roundToMultiple(0.0, Rational(1, 1000)), 0);
}

} // namespace
} // namespace halfspace
