#include "lessons/term/root_sum.h"

#include "lessons/term/real.h"
#include "tests/lessons/term/truth.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

namespace halfspace {
namespace {

using namespace test;

Truth truthOf(const RootSum &sum) {
  return std::accumulate(
      sum.summands().begin(), sum.summands().end(), Truth(0),
      [](const Truth &total, const Surd &each) { return Truth(total + test::truthOf(each)); });
}

/// Sums of roots of fractions; of every second one the radicands are beyond what is factored.
class RandomSums {
public:
  explicit RandomSums(std::uint64_t seed) : m_engine(seed) {}

  RootSum next() {
    const Rational scale = integer(0, 1) == 0 ? Rational(1) : Rational(1'000'000'007) * 1'000'000'009;
    RootSum sum;
    for (int count = integer(1, 3); count > 0; --count)
      sum = sum + RootSum(Surd::root(scale * integer(1, 12), Rational(integer(-9, 9), integer(1, 9))));
    return sum + RootSum(Rational(integer(-9, 9), integer(1, 9)));
  }

private:
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }

  std::mt19937_64 m_engine;
};

TEST(RootSum, OfSeededSums_IsWhatTheyComeTo) {
  RandomSums random(1);
  for (int i = 0; i < 300; ++i) {
    const RootSum a = random.next();
    const RootSum b = random.next();
    const Truth scale = 1 + mp::abs(truthOf(a)) + mp::abs(truthOf(b));
    const auto isNear = [&scale](const Truth &x, const Truth &y) {
      return mp::abs(Truth(x - y)) < Truth("1e-150") * scale * scale;
    };
    EXPECT_TRUE(isNear(truthOf(a + b), truthOf(a) + truthOf(b)));
    EXPECT_TRUE(isNear(truthOf(a * b), truthOf(a) * truthOf(b)));
  }
}

TEST(RootSum, OfWhatIsZeroByAlgebra_HasNoSummands) {
  RandomSums random(2);
  for (int i = 0; i < 300; ++i) {
    const RootSum a = random.next();
    const RootSum b = random.next();
    const RootSum squares = a * a + -(b * b);
    EXPECT_TRUE(((a + b) * (a + -b) + -squares).summands().empty());
  }
}

TEST(RootSum, OfOneRootWrittenInTwoWaysBeyondWhatIsFactored_IsOneRoot) {
  const Rational large = Rational(1'000'000'007) * 1'000'000'009;
  const Surd root = Surd::root(large);
  const Surd triple = Surd::root(large * 9);
  EXPECT_EQ((RootSum(triple) + RootSum(root)).summands().size(), 1U);
  EXPECT_TRUE((RootSum(triple) + RootSum(root * Rational(-3))).summands().empty());
}

/// √(n² + 1) + √(n² − 1) − 2n is about −1/(4n³), far below the digits of its summands.
TEST(Real, ASumOfRootsThatNearlyCancels_HasItsSignAndItsDigits) {
  for (const int exponent : {3, 20, 60, 150}) {
    const Rational n = powerOfTen(exponent);
    const Real sum = Real(Surd::root(n * n + 1)) + Real(Surd::root(n * n - 1)) - Real(2 * n);
    EXPECT_EQ(sign(sum), -1);
    const Real inUnits = sum * Real(n * n * n);
    EXPECT_NEAR(toDouble(inUnits), -0.25, 1e-6);
  }
}

} // namespace
} // namespace halfspace
