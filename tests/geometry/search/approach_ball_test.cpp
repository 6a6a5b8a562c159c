#include "geometry/search/approach_ball.h"

#include "geometry/decide.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

const Vec3<double> middle(1, 2, 3);
constexpr double radius = 2;
/// As near as a ray is brought.
const Rational nearby = Rational(1 << 20) * 2;

Rational squareFromMiddle(const ExactVec3 &point) {
  const ExactVec3 way = point - exactly(middle);
  return dot(way, way);
}

/// A point of the ball, and a way to a place that is so far away.
struct Far {
  ExactVec3 target;
  ExactVec3 way;
};

Far farFrom(RandomNumbers &random, int exponent) {
  const ExactVec3 target = exactly(middle) + random.wholeVector(5) / Rational(5);
  return {target, random.nonZeroWholeVector(9) * powerOfTen(exponent) / Rational(7)};
}

TEST(ApproachBall, FromFarAway_ComesNearAndNotIntoIt) { // law (1)
  RandomNumbers random(1);
  for (const int exponent : {8, 9, 15, 20, 40, 100})
    for (int i = 0; i < 50; ++i) {
      const auto [target, way] = farFrom(random, exponent);
      const Ray<Rational> ray{target + way, -way / Rational(random.integer(1, 9))};
      const auto t = approachBall(ray, middle, radius);
      ASSERT_TRUE(t) << exponent;
      EXPECT_GT(*t, 0);
      const ExactVec3 there = pointAt(ray, *t);
      EXPECT_LE(squareFromMiddle(there), 3 * nearby * nearby) << exponent;
      // Still outside, and what it is aimed at lies ahead.
      EXPECT_GT(squareFromMiddle(there), Rational(4));
      EXPECT_GT(dot(target - there, ray.direction), 0) << exponent;
    }
}

TEST(ApproachBall, FromNear_BeginsAtTheOrigin) {
  RandomNumbers random(2);
  for (int i = 0; i < 50; ++i) {
    const ExactVec3 origin = random.wholeVector(100'000) / Rational(3);
    EXPECT_EQ(approachBall({origin, random.nonZeroWholeVector(9)}, middle, radius), Rational(0));
  }
}

TEST(ApproachBall, FromFarAwayAndPastIt_OrAwayFromIt_SaysThatNothingIsMet) {
  RandomNumbers random(3);
  for (const int exponent : {8, 20, 100})
    for (int i = 0; i < 50; ++i) {
      const auto [target, way] = farFrom(random, exponent);
      EXPECT_FALSE(approachBall({target + way, way}, middle, radius)) << exponent;
      const ExactVec3 aside = ExactVec3(way.y, -way.x, 0) + ExactVec3(0, way.z, -way.y);
      if (!isZero(aside)) {
        EXPECT_FALSE(approachBall({target + way, aside - way}, middle, radius)) << exponent;
      }
    }
}

TEST(ApproachBall, BeyondTheRangeOfDoubles_BeginsAtTheOrigin) {
  const Rational far = powerOfTen(400);
  EXPECT_EQ(approachBall({{far, 0, 0}, {-1, 0, 0}}, middle, radius), Rational(0));
  EXPECT_EQ(approachBall({{powerOfTen(20), 0, 0}, {-1 / far, 0, 0}}, middle, radius), Rational(0));
}

} // namespace
} // namespace halfspace
