#include "geometry/surd.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace halfspace {
namespace {

/// √square · factor + shift
Surd surd(const Rational &square, const Rational &factor = 1, const Rational &shift = 0) {
  return Surd::root(square, factor) + shift;
}

bool isSquareFree(const Rational &whole) {
  for (Rational root = 2; root * root <= whole; root += 1)
    if ((whole / (root * root)).isInteger())
      return false;
  return true;
}

/// Whether no other double lies nearer to the exact value, decided exactly.
testing::AssertionResult isNearestDoubleOf(double rounded, const Surd &value) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Rational below = (exactly(rounded) + exactly(std::nextafter(rounded, -infinity))) / 2;
  const Rational above = (exactly(rounded) + exactly(std::nextafter(rounded, infinity))) / 2;
  if ((value + Rational(-below)).sign() >= 0 && (value + Rational(-above)).sign() <= 0)
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << rounded << " is not the double nearest to "
                                     << toText(value).value_or("?");
}

/// The fractions p/q with p² − 2q² = ±1: each is nearer to √2 than the one before, on the other side.
std::vector<std::pair<Rational, Rational>> bestFractionsOfRootTwo(int count) {
  std::vector<std::pair<Rational, Rational>> fractions{{1, 1}};
  while (static_cast<int>(fractions.size()) < count) {
    const auto [p, q] = fractions.back();
    fractions.emplace_back(p + 2 * q, p + q);
  }
  return fractions;
}

TEST(SurdText, EachForm_IsWrittenAsTheFormatSays) {
  EXPECT_EQ(toText(Surd()), "0");
  EXPECT_EQ(toText(Surd(Rational(-10, 3))), "-10/3");
  EXPECT_EQ(toText(surd(2)), "sqrt(2)");
  EXPECT_EQ(toText(surd(2, -1)), "-sqrt(2)");
  EXPECT_EQ(toText(surd(3, Rational(1, 3))), "1/3*sqrt(3)");
  EXPECT_EQ(toText(surd(3, -2)), "-2*sqrt(3)");
  EXPECT_EQ(toText(surd(5, Rational(3, 4), Rational(-1, 2))), "-1/2 + 3/4*sqrt(5)");
  EXPECT_EQ(toText(surd(5, Rational(-3, 4), Rational(-1, 2))), "-1/2 - 3/4*sqrt(5)");
  EXPECT_EQ(toText(surd(7, 1, 2)), "2 + sqrt(7)");
  EXPECT_EQ(toText(surd(7, -1, 2)), "2 - sqrt(7)");
}

TEST(SurdRoot, SquaresInTheRadicand_AreTakenOut) {
  EXPECT_EQ(toText(surd(12)), "2*sqrt(3)");
  EXPECT_EQ(toText(surd(Rational(1, 2))), "1/2*sqrt(2)");
  EXPECT_EQ(toText(surd(Rational(8, 27))), "2/9*sqrt(6)");
  EXPECT_EQ(toText(surd(Rational(9, 4))), "3/2");
  EXPECT_EQ(toText(surd(0)), "0");
  EXPECT_EQ(toText(surd(5, 0)), "0");
}

TEST(SurdRoot, AnyFraction_HasASquareFreeRadicandAndTheRightSquare) {
  RandomNumbers random(11);
  for (int i = 0; i < test::effort(3000); ++i) {
    const Rational square = abs(random.nonZeroRational(200));
    const Rational factor = random.nonZeroRational();
    const Surd value = surd(square, factor);
    ASSERT_TRUE(value.canonical());
    EXPECT_TRUE(isSquareFree(value.radicand())) << value.radicand();
    EXPECT_EQ(value.sign(), factor.sign()); // law (1)
    const Rational root = value.isRational() ? value.rationalPart() : value.rootFactor();
    EXPECT_EQ(Rational(root * root * value.radicand()), Rational(square * factor * factor));
    EXPECT_EQ(value.isRational(), value.radicand() == 1);
  }
}

TEST(SurdRoot, FactorTakenUnderTheRoot_HasTheSamePartsWithinAndBeyondTheLimit) { // law (2)
  RandomNumbers random(203);
  int beyond = 0;
  for (int i = 0; i < test::effort(1000); ++i) {
    const Rational square = abs(random.rational(50)) * powerOfTen(random.integer(-40, 40));
    const Rational factor = random.rational();
    const Rational k = i % 10 == 0 ? Rational(0) : abs(random.nonZeroRational());
    const Surd inside = surd(Rational(k * k * square), factor);
    const Surd outside = surd(square, Rational(k * factor));
    EXPECT_EQ(inside.rationalPart(), outside.rationalPart());
    EXPECT_EQ(inside.rootFactor(), outside.rootFactor());
    EXPECT_EQ(inside.radicand(), outside.radicand());
    EXPECT_EQ(inside.canonical(), outside.canonical());
    beyond += inside.canonical() ? 0 : 1;
  }
  EXPECT_GT(beyond, test::effort(50));
}

TEST(SurdRoot, LargePrimeFactors_AreFoundUpToTheLimit) {
  // Two primes just below a million, so that p²q is just below the limit; and the largest prime below it.
  EXPECT_EQ(toText(surd(Rational(999983) * 999983 * 999979)), "999983*sqrt(999979)");
  EXPECT_EQ(toText(surd(Rational(707106781) * 707106781 * 2)), "707106781*sqrt(2)");
  EXPECT_EQ(toText(surd(999999999999999989)), "sqrt(999999999999999989)");
  EXPECT_EQ(toText(surd(Rational(1, 999999999999999989))), "1/999999999999999989*sqrt(999999999999999989)");
  EXPECT_EQ(toText(surd(factorLimit)), "1000000000");
}

TEST(SurdRoot, BeyondTheLimit_HasNoTextUnlessItIsASquare) {
  const Rational beyond = factorLimit + 1;
  EXPECT_EQ(toText(surd(beyond)), std::nullopt);
  EXPECT_EQ(toText(surd(Rational(1 / beyond), 1, 3)), std::nullopt);
  EXPECT_FALSE(surd(beyond).canonical());
  EXPECT_EQ(toText(surd(Rational(beyond * beyond))), toText(beyond));
  EXPECT_EQ(surd(beyond).sign(), 1);
  EXPECT_TRUE(isNearestDoubleOf(toDouble(surd(beyond)), surd(beyond)));
}

TEST(SurdRoot, ValueWithinTheLimit_HasItsTextHoweverItWasComeBy) {
  // 10^10/√(3·10^20) = 1/√3: what is judged is the value's own square, 1/3.
  const Rational large = powerOfTen(10);
  EXPECT_EQ(toText(overRoot(large, Rational(3 * large * large))), "1/3*sqrt(3)");
  EXPECT_EQ(toText(surd(Rational(large * large * 3)) * Rational(1 / large)), "sqrt(3)");
  EXPECT_EQ(toText(surd(3) * large), std::nullopt);
}

TEST(SurdEquality, SameValueInTwoForms_IsEqual) {
  const Rational beyond = factorLimit + 1;
  EXPECT_EQ(surd(12), surd(3, 2));
  EXPECT_EQ(surd(Rational(4 * beyond)), surd(beyond, 2));
  EXPECT_FALSE(surd(2) == surd(2, -1));
  EXPECT_FALSE(surd(2) == surd(3));
  EXPECT_FALSE(surd(2, 1, 1) == surd(2));
}

TEST(SurdArithmetic, ScalingShiftingAndNegating_ActOnBothParts) {
  const Surd value = surd(5, Rational(3, 4), Rational(-1, 2));
  EXPECT_EQ(toText(value * Rational(-2)), "1 - 3/2*sqrt(5)");
  EXPECT_EQ(toText(value * Rational(0)), "0");
  EXPECT_EQ(toText(value + Rational(1, 2)), "3/4*sqrt(5)");
  EXPECT_EQ(toText(-value), "1/2 - 3/4*sqrt(5)");
  EXPECT_EQ(toText(Surd(Rational(2, 3)) * Rational(3)), "2");
}

TEST(SurdArithmetic, AnyValueWithinAndBeyondTheLimit_ObeysItsLaws) {
  RandomNumbers random(204);
  int beyond = 0;
  for (int i = 0; i < test::effort(1000); ++i) {
    const Rational square = abs(random.rational(50)) * powerOfTen(random.integer(-40, 40));
    const Surd x = surd(square, random.rational(), random.rational());
    const Rational r = random.rational();
    const Rational k = i % 10 == 0 ? Rational(0) : random.nonZeroRational();
    EXPECT_EQ((x + r) * k, x * k + Rational(r * k)); // law (1)
    EXPECT_EQ(-x, x * Rational(-1));                 // law (2)
    EXPECT_EQ(x + r + Rational(-r), x);              // law (3)
    EXPECT_TRUE(k == 0 || x * k * Rational(1 / k) == x);
    EXPECT_EQ((-x).sign(), -x.sign());     // law (1) of the sign
    EXPECT_EQ(toDouble(-x), -toDouble(x)); // law (1) of the double
    beyond += x.canonical() ? 0 : 1;
  }
  EXPECT_GT(beyond, test::effort(50));
}

TEST(SurdSquare, OfAnyValue_ObeysItsLaws) {
  RandomNumbers random(31);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Rational square = abs(random.rational(50));
    const Rational factor = random.rational();
    const Surd x = surd(square, factor, random.rational());
    EXPECT_EQ((-x).squared(), x.squared()); // law (1)
    EXPECT_EQ(x.squared().sign(), x.sign() * x.sign());
    EXPECT_NEAR(toDouble(x.squared()), toDouble(x) * toDouble(x), 1e-12 * toDouble(x.squared()));
    EXPECT_EQ(surd(square, factor).squared(), Surd(Rational(factor * factor * square))); // law (2)
  }
}

TEST(SurdOrder, OfAnyTwo_IsThatOfTheirDoubles_AndObeysItsLaws) {
  RandomNumbers random(32);
  for (int i = 0; i < test::effort(2000); ++i) {
    const Surd x = surd(abs(random.rational(50)), random.rational(), random.rational());
    const Surd y = surd(abs(random.rational(50)), random.rational(), random.rational());
    if (toDouble(x) != toDouble(y)) {
      EXPECT_EQ(x < y, toDouble(x) < toDouble(y));
    }
    EXPECT_EQ(x <=> y, -y <=> -x); // law (1)
    EXPECT_EQ(x <=> x, std::strong_ordering::equal);
    EXPECT_EQ((x <=> y) == std::strong_ordering::equal, x == y);
  }
}

/// √2 + p/q and √3 differ by less than doubles tell where p/q comes near √3 − √2.
TEST(SurdOrder, OfTwoRadicands_IsDecidedExactly) {
  Rational below = 0;
  Rational above = 1;
  for (int i = 0; i < 120; ++i) {
    const Rational middle = (below + above) / 2;
    const bool isBelow = surd(2) + middle < surd(3);
    // √2 + m < √3 where m² + 2m√2 + 2 < 3, which is where 8m² < (1 − m²)².
    EXPECT_EQ(isBelow, 8 * middle * middle < (1 - middle * middle) * (1 - middle * middle));
    (isBelow ? below : above) = middle;
  }
  EXPECT_EQ(toDouble(below), toDouble(above)) << "it came as near as that";
}

TEST(SurdSign, PartsThatPullApart_AreDecidedExactly) {
  int expected = -1;
  for (const auto &[p, q] : bestFractionsOfRootTwo(300)) {
    const Surd difference = surd(2, Rational(-q), Rational(p));
    EXPECT_EQ(difference.sign(), expected);
    EXPECT_EQ((-difference).sign(), -expected);
    expected = -expected;
  }
}

TEST(SurdSign, Conjugates_MultiplyToTheSignOfTheirNorm) { // law (2)
  RandomNumbers random(12);
  for (int i = 0; i < test::effort(3000); ++i) {
    const Rational square = abs(random.nonZeroRational(50));
    const Rational factor = random.rational();
    const Rational shift = random.rational();
    const Rational norm = shift * shift - factor * factor * square;
    EXPECT_EQ(surd(square, factor, shift).sign() * surd(square, Rational(-factor), shift).sign(),
              norm.sign());
  }
}

TEST(SurdToDouble, AnyValue_IsTheNearestDouble) {
  RandomNumbers random(13);
  for (int i = 0; i < test::effort(3000); ++i) {
    const Rational scale = powerOfTen(random.integer(-60, 60));
    const Surd value =
        surd(abs(random.nonZeroRational(1000)), Rational(random.rational() * scale), random.rational());
    EXPECT_TRUE(isNearestDoubleOf(toDouble(value), value));
  }
}

TEST(SurdToDouble, NearTheMiddleBetweenTwoDoubles_IsTheNearerOne) {
  const Surd pinned = surd(81301, Rational(19, 1200000000000000), -14);
  EXPECT_TRUE(isNearestDoubleOf(toDouble(pinned), pinned));
  RandomNumbers random(14);
  for (int i = 0; i < test::effort(3000); ++i) {
    const double below = random.integer(1, 1 << 30) * 0x1p-20;
    const Rational middle = (exactly(below) + exactly(std::nextafter(below, 1e9))) / 2;
    const Rational factor = (random.integer(0, 1) == 0 ? 1 : -1) * powerOfTen(random.integer(-18, -10));
    const Surd value = surd(random.integer(2, 50), factor, middle);
    EXPECT_TRUE(isNearestDoubleOf(toDouble(value), value));
  }
}

TEST(SurdToDouble, PartsThatCancel_LoseNoDigits) {
  for (const auto &[p, q] : bestFractionsOfRootTwo(300)) {
    const Surd difference = surd(2, Rational(-q), Rational(p));
    EXPECT_TRUE(isNearestDoubleOf(toDouble(difference), difference));
  }
}

TEST(SurdToDouble, TinyAndHugeValues_KeepTheirRange) {
  EXPECT_EQ(toDouble(surd(powerOfTen(-801))), 0);
  EXPECT_EQ(toDouble(surd(powerOfTen(801))), std::numeric_limits<double>::infinity());
  EXPECT_EQ(toDouble(surd(powerOfTen(801), -1)), -std::numeric_limits<double>::infinity());
  const Surd tiny = surd(Rational(2 * powerOfTen(-640)));
  EXPECT_TRUE(isNearestDoubleOf(toDouble(tiny), tiny));
}

TEST(OverRoot, DoubleAndFraction_Agree) {
  EXPECT_DOUBLE_EQ(overRoot(30.0, 9.0), 10.0);
  EXPECT_EQ(overRoot(Rational(30), Rational(9)), Surd(10));
  EXPECT_DOUBLE_EQ(overRoot(1.0, 3.0), toDouble(overRoot(Rational(1), Rational(3))));
}

TEST(OverRoot, AnyFraction_IsTheSameForAMultipleAndTheRootBySquare) {
  RandomNumbers random(205);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Rational value = random.rational();
    const Rational square = abs(random.nonZeroRational());
    const Rational k = abs(random.nonZeroRational());
    EXPECT_EQ(overRoot(Rational(k * value), Rational(k * k * square)), overRoot(value, square)); // law (1)
    EXPECT_EQ(overRoot(value, square) * square, timesRoot(value, square));                       // law (2)
  }
}

} // namespace
} // namespace halfspace
