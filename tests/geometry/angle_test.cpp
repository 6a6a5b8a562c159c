#include "geometry/angle.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

TEST(CosineBetween, OfKnownAngles_IsExact) {
  EXPECT_EQ(cosineBetween(ExactVec3(1, 0, 0), ExactVec3(1, 1, 0)), Surd::root(2, Rational(1, 2)));
  EXPECT_EQ(cosineBetween(ExactVec3(1, 0, 0), ExactVec3(-1, 1, 0)), Surd::root(2, Rational(-1, 2)));
  EXPECT_EQ(cosineBetween(ExactVec3(1, 1, 0), ExactVec3(0, 1, 1)), Surd(Rational(1, 2)));
  EXPECT_EQ(cosineBetween(ExactVec3(1, 2, 2), ExactVec3(2, 3, 6)), Surd(Rational(20, 21)));
}

TEST(CosineBetween, WithAZeroVector_IsZero) {
  EXPECT_EQ(cosineBetween(ExactVec3(0, 0, 0), ExactVec3(1, 2, 3)), Surd(0));
  EXPECT_EQ(cosineBetween(Vec3<double>(1, 2, 3), Vec3<double>(0, 0, 0)), 0.0);
}

TEST(CosineBetween, OfAnyVectors_KeepsItsLaws) {
  RandomNumbers random(611);
  for (int i = 0; i < test::effort(10'000); ++i) {
    const ExactVec3 a = random.nonZeroWholeVector(2);
    const ExactVec3 b = random.nonZeroWholeVector(2);
    const Surd cosine = cosineBetween(a, b);
    EXPECT_EQ(cosineBetween(b, a), cosine); // law (1)
    const Rational k = random.nonZeroRational();
    EXPECT_EQ(cosineBetween(ExactVec3(a * k), b), k < 0 ? -cosine : cosine); // law (2)
    const bool isOnOneLine = isZero(cross(a, b));
    EXPECT_EQ(isOnOneLine, cosine == Surd(1) || cosine == Surd(-1)); // law (3)
    EXPECT_EQ(dot(a, b) == 0, cosine == Surd(0));
  }
}

TEST(AcuteAngle, OfKnownAngles_IsExact) {
  const auto obtuse = measureAcuteAngle(ExactVec3(1, 0, 0), ExactVec3(-1, 1, 0));
  EXPECT_EQ(obtuse.which, AcuteAngleCase::Oblique);
  EXPECT_EQ(obtuse.product, -1);
  EXPECT_EQ(obtuse.cosine, Surd::root(2, Rational(1, 2)));
  EXPECT_EQ(obtuse.sine, Surd::root(2, Rational(1, 2)));
  const auto sixty = measureAcuteAngle(ExactVec3(1, 1, 0), ExactVec3(0, 1, 1));
  EXPECT_EQ(sixty.cosine, Surd(Rational(1, 2)));
  EXPECT_EQ(sixty.sine, Surd::root(3, Rational(1, 2)));
  EXPECT_EQ(measureAcuteAngle(ExactVec3(1, 2, 2), ExactVec3(2, -2, 1)).which, AcuteAngleCase::Perpendicular);
  EXPECT_EQ(measureAcuteAngle(ExactVec3(1, 2, 2), ExactVec3(-2, -4, -4)).which, AcuteAngleCase::Parallel);
}

TEST(AcuteAngle, WithAZeroVector_IsACaseOfItsOwn) {
  const ExactVec3 none(0, 0, 0);
  for (const auto &angle : {measureAcuteAngle(none, ExactVec3(1, 2, 3)),
                            measureAcuteAngle(ExactVec3(1, 2, 3), none), measureAcuteAngle(none, none)})
    EXPECT_EQ(angle.which, AcuteAngleCase::ZeroVector);
}

TEST(AcuteAngle, OfAnyVectors_KeepsItsLaws) {
  RandomNumbers random(612);
  std::map<AcuteAngleCase, int> cases;
  for (int i = 0; i < test::effort(10'000); ++i) {
    const ExactVec3 a = random.wholeVector(2);
    const ExactVec3 b = random.wholeVector(2);
    const auto angle = measureAcuteAngle(a, b);
    ++cases[angle.which];
    const auto swapped = measureAcuteAngle(b, a); // law (1)
    EXPECT_EQ(swapped.which, angle.which);
    EXPECT_EQ(swapped.cosine, angle.cosine);
    EXPECT_EQ(swapped.sine, angle.sine);
    const Rational k = random.nonZeroRational();
    const auto scaled = measureAcuteAngle(ExactVec3(a * k), b); // law (2)
    EXPECT_EQ(scaled.which, angle.which);
    EXPECT_EQ(scaled.product, Rational(angle.product * k));
    EXPECT_EQ(scaled.cosine, angle.cosine);
    EXPECT_EQ(scaled.sine, angle.sine);
    if (angle.which == AcuteAngleCase::ZeroVector) {
      EXPECT_TRUE(isZero(a) || isZero(b));
      continue;
    }
    EXPECT_GE(angle.cosine.sign(), 0); // law (3)
    EXPECT_GE(angle.sine.sign(), 0);
    EXPECT_EQ(angle.cosine.squared() + angle.sine.squared().rationalPart(), Surd(1));
    EXPECT_EQ(angle.sine == Surd(0), angle.which == AcuteAngleCase::Parallel); // law (4)
    EXPECT_EQ(angle.cosine == Surd(0), angle.which == AcuteAngleCase::Perpendicular);
  }
  EXPECT_EQ(cases.size(), 4U) << "a case did not come up";
}

TEST(AcuteAngle, DoublesOnSmallIntegers_GiveTheSameAngle) {
  RandomNumbers random(613);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 a = random.wholeVector(5);
    const ExactVec3 b = random.wholeVector(5);
    const auto exact = measureAcuteAngle(a, b);
    const auto rounded = measureAcuteAngle(toDouble(a), toDouble(b));
    EXPECT_EQ(rounded.which, exact.which);
    EXPECT_DOUBLE_EQ(rounded.cosine, toDouble(exact.cosine));
    EXPECT_DOUBLE_EQ(rounded.sine, toDouble(exact.sine));
  }
}

} // namespace
} // namespace halfspace
