// Points in whole numbers, and what is computed of them, against the points themselves.
#include "geometry/integer.h"
#include "geometry/weighted_point.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace halfspace {
namespace {

TEST(Weighted, AnyPoint_IsItsMultipleInWholeNumbersWithoutACommonFactor) {
  RandomNumbers random(175);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 point = i % 3 == 0 ? random.wholeVector(20) : random.vector();
    const auto whole = weighted(point);
    EXPECT_EQ(whole.position, ExactVec3(point * whole.weight)); // law (1)
    Integer common = 0;
    for (const Rational &number : {whole.position.x, whole.position.y, whole.position.z, whole.weight}) {
      EXPECT_TRUE(number.isInteger()); // law (2)
      common = mp::gcd(common, integerOf(number));
    }
    EXPECT_EQ(common, 1);
    EXPECT_GT(whole.weight, 0);
  }
}

TEST(WeightedPoint, PlanesLinesAndSides_AreThoseOfThePointsTimesTheirWeights) { // law (1) of each
  RandomNumbers random(176);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 p = random.vector();
    const ExactVec3 q = random.vector();
    const ExactVec3 r = i % 4 == 0 ? ExactVec3(p + (q - p) * random.rational(2)) : random.vector();
    const auto wholeP = weighted(p);
    const auto wholeQ = weighted(q);
    const auto wholeR = weighted(r);

    const auto plane = planeThrough(p, q, r);
    const auto wholePlane = planeThrough(wholeP, wholeQ, wholeR);
    const Rational planeScale = wholeP.weight * wholeQ.weight * wholeR.weight;
    EXPECT_EQ(wholePlane.normal, ExactVec3(plane.normal * planeScale));
    EXPECT_EQ(wholePlane.offset, plane.offset * planeScale);

    const auto line = lineThrough(p, q);
    const auto wholeLine = lineThrough(wholeP, wholeQ);
    const Rational lineScale = wholeP.weight * wholeQ.weight;
    EXPECT_EQ(wholeLine.direction, ExactVec3(line.direction * lineScale));
    EXPECT_EQ(wholeLine.moment, ExactVec3(line.moment * lineScale));

    const Plane<Rational> any{random.vector(), random.rational()};
    EXPECT_EQ(evaluate(any, wholeP), evaluate(any, p) * wholeP.weight);
  }
}

TEST(MeanOf, AnyPoints_IsTheirSumByTheirNumber) { // law (1)
  RandomNumbers random(177);
  for (int i = 0; i < test::effort(500); ++i) {
    const ExactVec3 p = random.vector();
    const ExactVec3 q = random.vector();
    const ExactVec3 r = random.vector();
    const auto pointOf = [](const WeightedPoint<Rational> &whole) {
      return ExactVec3(whole.position * Rational(1 / whole.weight));
    };
    EXPECT_EQ(pointOf(meanOf({weighted(p)})), p);
    EXPECT_EQ(pointOf(meanOf({weighted(p), weighted(q), weighted(r)})),
              ExactVec3((p + q + r) * Rational(1, 3)));
  }
}

TEST(Rounded, PointWithinAndBeyondTheRangeOfDoubles_IsTheNearestDoublesOrItself) {
  const ExactVec3 point(Rational(1, 3), Rational(-2, 7), 5);
  EXPECT_EQ(rounded(weighted(point)), weighted(ExactVec3(exactly(1.0 / 3), exactly(-2.0 / 7), 5)));
  const auto far = weighted(ExactVec3(powerOfTen(400), Rational(1, 3), 0));
  EXPECT_EQ(rounded(far), far);
}

} // namespace
} // namespace halfspace
