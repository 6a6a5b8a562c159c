#include "lessons/term/real.h"

#include "lessons/term/interval.h"
#include "tests/lessons/term/term_samples.h"
#include "tests/lessons/term/truth.h"

#include <gtest/gtest.h>

#include <random>

namespace halfspace {
namespace {

using namespace test;

/// Calculated with two hundred digits, two results are the same when they agree in most of them.
const Truth sameDigits("1e-150");

Real rootOf(int square) { return Surd::root(square); }

Truth truthOf(const Real &number) { return test::truthOf(*number.exact()); }

bool contains(const Real &number, const Truth &truth) {
  const Interval within = number.bounds();
  return Truth(within.low) <= truth && truth <= Truth(within.high);
}

/// Numbers A + B√n with small parts.
class RandomSurds {
public:
  explicit RandomSurds(std::uint64_t seed) : m_engine(seed) {}
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }
  Surd over(int radicand) {
    return Surd::root(radicand, Rational(integer(-9, 9), integer(1, 9))) +
           Rational(integer(-20, 20), integer(1, 9));
  }

private:
  std::mt19937_64 m_engine;
};

TEST(Real, OfFractionsAndOneRoot_IsCalculatedExactly) {
  RandomSurds random(1);
  for (int i = 0; i < 300; ++i) {
    const int radicand = random.integer(1, 8);
    const Real a = random.over(radicand);
    const Real b = random.over(radicand);
    SCOPED_TRACE(textOf(a) + " and " + textOf(b));
    for (const auto &[result, truth] :
         {std::pair(a + b, Truth(truthOf(a) + truthOf(b))), std::pair(a - b, Truth(truthOf(a) - truthOf(b))),
          std::pair(a * b, Truth(truthOf(a) * truthOf(b)))}) {
      ASSERT_TRUE(result.exact());
      EXPECT_LT(mp::abs(Truth(truthOf(result) - truth)), sameDigits);
      EXPECT_TRUE(contains(result, truth));
    }
    const auto ratio = quotient(a, b);
    ASSERT_EQ(ratio.has_value(), sign(b) != 0);
    if (ratio) {
      EXPECT_LT(mp::abs(Truth(truthOf(*ratio) * truthOf(b) - truthOf(a))), sameDigits);
    }
  }
}

/// A number and what it should come to.
struct Checked {
  Real value;
  Truth truth;
};

/// One of the four operations; a product where it would divide by zero.
Checked operated(int operation, const Checked &a, const Checked &b) {
  const auto ratio = quotient(a.value, b.value);
  if (operation == 0)
    return {a.value + b.value, a.truth + b.truth};
  if (operation == 1)
    return {a.value - b.value, a.truth - b.truth};
  if (operation == 2 && ratio)
    return {*ratio, a.truth / b.truth};
  return {a.value * b.value, a.truth * b.truth};
}

TEST(Real, OfSeveralRoots_LiesBetweenItsBounds) {
  RandomSurds random(2);
  const auto next = [&](int radicand) {
    const Real value = random.over(radicand);
    return Checked{value, truthOf(value)};
  };
  for (int i = 0; i < 200; ++i) {
    Checked result = next(2);
    for (const int radicand : {3, 5, 6})
      result = operated(random.integer(0, 3), result, next(radicand));
    const auto &[value, truth] = result;
    EXPECT_TRUE(value.exact() || contains(value, truth)) << truth;
    EXPECT_EQ(sign(value), truth == 0 ? 0 : truth > 0 ? 1 : -1) << truth;
    EXPECT_NEAR(toDouble(value), truth.convert_to<double>(), 1e-12 * (1 + std::abs(toDouble(value))));
  }
}

TEST(RealSum, OfTwoDifferentRoots_IsNoExactNumberButNearlyKnown) {
  const Real sum = rootOf(2) + rootOf(3);
  EXPECT_EQ(sum.exact(), nullptr);
  EXPECT_TRUE(contains(sum, mp::sqrt(Truth(2)) + mp::sqrt(Truth(3))));
  EXPECT_LT(Interval::Bound(sum.bounds().high - sum.bounds().low), Interval::Bound("1e-115"));
  EXPECT_EQ(sign(sum), 1);
  EXPECT_EQ(sign(-sum), -1);
  EXPECT_EQ(areEqual(sum, rootOf(10)), false);
  EXPECT_EQ(areEqual(sum, sum), true);
  EXPECT_EQ(areEqual(sum, rootOf(3) + rootOf(2)), true);
}

TEST(RealSum, OfRootsThatCancel_IsZero) {
  const Real zero = (rootOf(2) + rootOf(3)) - (rootOf(2) + rootOf(3));
  EXPECT_EQ(textOf(zero), "0");
  EXPECT_EQ(sign(zero), 0);
  EXPECT_FALSE(quotient(1, zero));
}

TEST(RealProduct, WithZero_IsZeroWhateverTheOtherIs) {
  EXPECT_EQ(textOf(Real(0) * *squareRoot(Real(Surd::root(2) + Rational(1)))), "0");
}

TEST(RealSum, OfRootsOfRoots_IsAsNearToZeroAsItIsKnown) {
  const Real nested = *squareRoot(Real(Surd::root(2, 2) + Rational(3))); // 1 + √2
  const Real unknown = nested - rootOf(2) - Real(1);
  EXPECT_EQ(sign(unknown), std::nullopt);
  EXPECT_EQ(toDouble(unknown), 0);
}

TEST(RealProduct, OfTwoDifferentRoots_IsTheRootOfTheProduct) {
  EXPECT_EQ(textOf(rootOf(2) * rootOf(3)), "sqrt(6)");
  EXPECT_EQ(textOf(rootOf(6) * rootOf(10)), "2*sqrt(15)");
  EXPECT_EQ((Real(Surd::root(2) + Rational(1)) * rootOf(3)).exact(), nullptr);
}

TEST(Quotient, ByASumWithARoot_IsExact) {
  EXPECT_EQ(textOf(*quotient(1, Surd::root(2) + Rational(1))), "-1 + sqrt(2)");
  EXPECT_EQ(textOf(*quotient(6, rootOf(12))), "sqrt(3)");
}

TEST(Quotient, ByZero_IsNothing) {
  EXPECT_FALSE(quotient(1, 0));
  EXPECT_FALSE(quotient(0, 0));
  EXPECT_FALSE(quotient(1, rootOf(2) - rootOf(2)));
}

TEST(Quotient, ByWhatIsNotExact_LiesBetweenItsBounds) {
  const auto ratio = quotient(1, rootOf(2) + rootOf(3));
  ASSERT_TRUE(ratio);
  EXPECT_TRUE(contains(*ratio, mp::sqrt(Truth(3)) - mp::sqrt(Truth(2))));
}

TEST(SquareRoot, OfAFraction_IsExact) {
  EXPECT_EQ(textOf(*squareRoot(Rational(9, 4))), "3/2");
  EXPECT_EQ(textOf(*squareRoot(Rational(4, 3))), "2/3*sqrt(3)");
  EXPECT_EQ(textOf(*squareRoot(0)), "0");
}

TEST(SquareRoot, OfANegativeNumber_IsNothing) {
  EXPECT_FALSE(squareRoot(-1));
  EXPECT_FALSE(squareRoot(Real(Surd::root(2) + Rational(-2))));
}

TEST(SquareRoot, OfARoot_LiesBetweenItsBounds) {
  const auto root = squareRoot(Real(Surd::root(2) + Rational(1)));
  ASSERT_TRUE(root);
  EXPECT_TRUE(contains(*root, mp::sqrt(Truth(mp::sqrt(Truth(2)) + 1))));
}

/// p − q√2 = 1/(p + q√2) for the best fractions p/q: the difference has lost all its digits.
TEST(SquareRoot, OfANumberTooSmallForItsBounds_StillContainsIt) {
  Rational p = 3;
  Rational q = 2;
  for (int i = 0; i < 180; ++i) {
    const Rational next = 3 * p + 4 * q;
    q = 2 * p + 3 * q;
    p = next;
  }
  const Surd tiny = Surd::root(2, -q) + p;
  const auto root = squareRoot(Real(tiny));
  ASSERT_TRUE(root);
  // The truth loses as many digits as p has when it is calculated as a difference.
  const Truth truth = mp::sqrt(Truth(1 / Truth(truthOf(p) + mp::sqrt(Truth(2)) * truthOf(q))));
  EXPECT_TRUE(contains(*root, truth));
  EXPECT_NEAR(toDouble(*root) / truth.convert_to<double>(), 1, 1e-12);
}

TEST(AreEqual, OfExactNumbers_IsDecided) {
  EXPECT_EQ(areEqual(rootOf(12), Surd::root(3, 2)), true);
  EXPECT_EQ(areEqual(rootOf(12), Rational(346, 100)), false);
}

} // namespace
} // namespace halfspace
