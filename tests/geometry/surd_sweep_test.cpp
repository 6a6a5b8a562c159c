// Surds through long calculations: their form, the limit of factoring, and the nearest double.
#include "geometry/integer.h"
#include "geometry/surd.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

bool isSquare(const Rational &whole) {
  const Rational root = rationalOf(mp::sqrt(integerOf(whole)));
  return root * root == whole;
}

/// The rule of the format for B·√n by its square alone: p or q beyond the limit and no square itself.
bool isBeyondLimit(const Rational &square) {
  const auto beyond = [](const Rational &part) { return part > factorLimit && !isSquare(part); };
  return beyond(square.numerator()) || beyond(square.denominator());
}

/// Products of small primes: their roots have squares in them as often as not.
Rational smoothFraction(RandomNumbers &random, int factors) {
  constexpr std::array<int, 8> primes{2, 2, 3, 5, 7, 11, 101, 10007};
  Rational value = 1;
  for (int i = 0; i < factors; ++i) {
    const Rational prime = primes[static_cast<std::size_t>(random.integer(0, 7))];
    value = random.integer(0, 1) == 0 ? Rational(value * prime) : Rational(value / prime);
  }
  return value;
}

/// The same value worked out in one step, to compare the way with.
struct Direct {
  Rational rational = 0;
  Rational factor = 1;
  Rational square = 1;

  [[nodiscard]] Rational rootSquare() const { return square * factor * factor; }
  [[nodiscard]] Surd value() const { return Surd::root(square, factor) + rational; }
};

void stepOn(Surd &value, Direct &direct, RandomNumbers &random) {
  const Rational number = smoothFraction(random, random.integer(1, 5)) * (random.integer(0, 1) == 0 ? 1 : -1);
  switch (random.integer(0, 3)) {
  case 0:
    value = -value;
    direct.rational = -direct.rational;
    direct.factor = -direct.factor;
    break;
  case 1:
    value = value + number;
    direct.rational += number;
    break;
  default:
    value = value * number;
    direct.rational *= number;
    direct.factor *= number;
  }
}

TEST(SurdSweep, AnyOrderOfOperations_HasATextExactlyWhereTheValueIsWithinTheLimit) {
  RandomNumbers random(151);
  int within = 0;
  int beyond = 0;
  for (int i = 0; i < test::effort(1000); ++i) {
    Direct direct;
    direct.square = smoothFraction(random, random.integer(1, 10));
    Surd value = Surd::root(direct.square);
    for (int step = 0; step < 8; ++step) {
      stepOn(value, direct, random);
      const bool expected = !isBeyondLimit(direct.rootSquare());
      (expected ? within : beyond) += 1;
      ASSERT_EQ(value.canonical(), expected) << "value " << i << ", step " << step;
      ASSERT_EQ(value, direct.value());
      ASSERT_EQ(toText(value), toText(direct.value())); // law (1) of the text
      if (expected) {
        ASSERT_EQ(value.rootFactor() * value.rootFactor() * value.radicand(),
                  value.isRational() ? Rational(0) : direct.rootSquare());
      }
    }
  }
  EXPECT_GT(within, test::effort(300));
  EXPECT_GT(beyond, test::effort(300));
}

TEST(SurdSweep, ScaledBeyondTheLimitAndBack_HasItsTextAgain) {
  RandomNumbers random(152);
  for (int i = 0; i < 300; ++i) {
    const Rational square = abs(random.nonZeroRational(100));
    const Rational factor = random.nonZeroRational();
    const Rational scale = powerOfTen(random.integer(12, 60));
    const Surd start = Surd::root(square, factor) + random.rational();
    const Surd far = start * scale;
    EXPECT_EQ(far.canonical(), !isBeyondLimit(Rational(square * factor * factor * scale * scale)));
    EXPECT_EQ(toText(far * (1 / scale)), toText(start));
    EXPECT_EQ(toText(-(-far + 1) * (-1 / scale) + 1 / scale), toText(-start + 2 / scale));
  }
}

TEST(SurdSweep, SquareAtTheLimit_HasATextAndOneBeyondOnlyIfItIsASquareItself) {
  // 10^18 − 11 is a prime; 10^18 is a square and so is (10^9 + 1)².
  const Rational prime = 999999999999999989;
  EXPECT_TRUE(Surd::root(prime).canonical());
  EXPECT_TRUE(Surd::root(Rational(1 / prime)).canonical());
  EXPECT_FALSE(Surd::root(prime, 2).canonical());
  EXPECT_TRUE(Surd::root(prime, Rational(1, 2)).canonical());
  EXPECT_TRUE(Surd::root(prime, Rational(1, 1000000007)).canonical())
      << "the denominator is a square beyond the limit";
  EXPECT_FALSE(Surd::root(Rational(factorLimit + 1)).canonical());
  EXPECT_EQ(toText(Surd::root(Rational(factorLimit) * 9)), "3000000000");
  EXPECT_EQ(toText(Surd::root(Rational(1000000002000000001, 2))), "1000000001/2*sqrt(2)");
}

/// Whether the double is the nearest one or its neighbour, decided exactly.
bool isWithinOneUnit(double rounded, const Surd &value) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Rational below = exactly(std::nextafter(rounded, -infinity));
  const Rational above = exactly(std::nextafter(rounded, infinity));
  return (value + Rational(-below)).sign() >= 0 && (value + Rational(-above)).sign() <= 0;
}

/// A fraction with some 2^bits as its denominator that lies so near to −B·√n.
Rational against(const Surd &root, unsigned bits) {
  const Rational power = rationalOf(Integer(1) << bits);
  return Rational(-roundToMultiple(exactly(toDouble(root)), Rational(1 / power)));
}

TEST(SurdToDouble, PartsThatCancelToAnyDegree_StayWithinOneUnit) {
  RandomNumbers random(153);
  for (int i = 0; i < test::effort(20'000); ++i) {
    const Rational square = random.integer(2, 1'000'000);
    const Rational factor = Rational(random.integer(1, 1'000'000)) / random.integer(1, 1'000'000);
    const Surd root = Surd::root(square, random.integer(0, 1) == 0 ? factor : Rational(-factor));
    const Surd value = root + against(root, static_cast<unsigned>(random.integer(0, 45)));
    ASSERT_TRUE(isWithinOneUnit(toDouble(value), value)) << toText(value).value_or("?");
  }
}

TEST(SurdToDouble, PartsOfAnySize_StayWithinOneUnit) {
  RandomNumbers random(154);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Surd root = Surd::root(abs(random.nonZeroRational(1000)) * powerOfTen(random.integer(-200, 200)),
                                 random.nonZeroRational() * powerOfTen(random.integer(-100, 100)));
    const Surd value = root + Rational(random.rational() * powerOfTen(random.integer(-200, 200)));
    ASSERT_TRUE(isWithinOneUnit(toDouble(value), value)) << i;
  }
}

TEST(SurdToDouble, HugePartsThatCancelAlmostWhole_StayWithinOneUnit) {
  // √(N² + 1) − N is about 1/(2N).
  for (int digits = 1; digits <= 200; digits += 7) {
    const Rational whole = powerOfTen(digits);
    const Surd value = Surd::root(Rational(whole * whole + 1)) + Rational(-whole);
    EXPECT_TRUE(isWithinOneUnit(toDouble(value), value)) << digits;
    EXPECT_TRUE(isWithinOneUnit(toDouble(-value), -value)) << digits;
  }
}

} // namespace
} // namespace halfspace
