#include "geometry/point_plane.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

const Plane<Rational> notesPlane = planeThrough(ExactVec3(5, 4, 7), ExactVec3(1, 2, 2));

TEST(MeasurePointPlane, NotesExample_IsTenAway) {
  const auto result = measurePointPlane(ExactVec3(11, 15, 8), notesPlane);
  EXPECT_EQ(result.which, PointPlaneCase::Positive);
  EXPECT_EQ(result.f, 30);
  EXPECT_EQ(result.normalSquared, 9);
  EXPECT_EQ(toText(result.signedDistance), "10");
  EXPECT_EQ(result.footParameter, Rational(10, 3));
  EXPECT_EQ(result.foot, ExactVec3(Rational(23, 3), Rational(25, 3), Rational(4, 3)));
}

TEST(MeasurePointPlane, LengthThatIsNoFraction_IsARoot) {
  const auto result =
      measurePointPlane(ExactVec3(0, 0, 0), planeThrough(ExactVec3(1, 0, 0), ExactVec3(1, 1, 1)));
  EXPECT_EQ(result.which, PointPlaneCase::Negative);
  EXPECT_EQ(toText(result.signedDistance), "-1/3*sqrt(3)");
  EXPECT_EQ(result.foot, ExactVec3(Rational(1, 3), Rational(1, 3), Rational(1, 3)));
}

TEST(MeasurePointPlane, ZeroNormal_IsACaseOfItsOwn) {
  const auto result = measurePointPlane(ExactVec3(1, 2, 3), Plane<Rational>{ExactVec3(0, 0, 0), 4});
  EXPECT_EQ(result.which, PointPlaneCase::ZeroNormal);
  EXPECT_EQ(result.f, 4);
  EXPECT_EQ(result.normalSquared, 0);
}

TEST(MeasurePointPlane, Foot_LiesOnThePlaneAlongTheNormalFromThePoint) {
  RandomNumbers random(31);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 point = random.vector();
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const auto result = measurePointPlane(point, plane);
    EXPECT_EQ(evaluate(plane, result.foot), 0); // law (1)
    EXPECT_TRUE(isZero(cross(ExactVec3(result.foot - point), plane.normal)));
    EXPECT_EQ(ExactVec3(point - plane.normal * result.footParameter), result.foot);
    EXPECT_EQ(result.signedDistance.sign(), result.f.sign());
    EXPECT_EQ(measurePointPlane(result.foot, plane).which, PointPlaneCase::On);
    const ExactVec3 way = point - result.foot;
    EXPECT_EQ(result.signedDistance, Surd::root(dot(way, way), result.f.sign())); // law (2)
    const ExactVec3 other = result.foot + cross(plane.normal, random.vector());
    const ExactVec3 longer = point - other;
    const ExactVec3 along = result.foot - other;
    EXPECT_EQ(dot(longer, longer), dot(way, way) + dot(along, along)); // law (3)
  }
}

TEST(MeasurePointPlane, MultipleOfThePlane_KeepsTheFootAndAllOfTheDistanceButItsSign) { // law (4)
  RandomNumbers random(32);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 point = random.vector();
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const auto result = measurePointPlane(point, plane);
    const Rational k = i % 2 == 0 ? Rational(-1) : random.nonZeroRational();
    const auto scaled =
        measurePointPlane(point, Plane<Rational>{plane.normal * k, Rational(plane.offset * k)});
    EXPECT_EQ(scaled.signedDistance, k < 0 ? -result.signedDistance : result.signedDistance);
    EXPECT_EQ(scaled.foot, result.foot);
    EXPECT_EQ(scaled.f, result.f * k);
  }
}

TEST(MeasurePointPlane, PointMovedThroughThePlane_IsOnItOnlyAtZero) {
  for (int k = 0; k <= 60; ++k) {
    const ExactVec3 step = notesPlane.normal * powerOfTen(-k);
    const ExactVec3 on(5, 4, 7);
    EXPECT_EQ(measurePointPlane(ExactVec3(on + step), notesPlane).which, PointPlaneCase::Positive);
    EXPECT_EQ(measurePointPlane(ExactVec3(on - step), notesPlane).which, PointPlaneCase::Negative);
    EXPECT_EQ(measurePointPlane(ExactVec3(on + step), notesPlane).signedDistance,
              Surd(Rational(3 * powerOfTen(-k))));
  }
  EXPECT_EQ(measurePointPlane(ExactVec3(5, 4, 7), notesPlane).which, PointPlaneCase::On);
}

TEST(MeasurePointPlane, Doubles_AgreeWithFractions) {
  RandomNumbers random(33);
  // Coordinates up to 20: the sums stay below 2000, so that their rounding errors do below this bound.
  const double bound = 1e-9;
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactVec3 point = random.vector();
    const ExactVec3 origin = random.vector();
    ExactVec3 normal = random.nonZeroVector();
    normal.x += normal.x < 0 ? -1 : 1;
    const auto exact = measurePointPlane(point, planeThrough(origin, normal));
    const auto rounded = measurePointPlane(toDouble(point), planeThrough(toDouble(origin), toDouble(normal)));
    EXPECT_NEAR(rounded.f, toDouble(exact.f), bound);
    EXPECT_NEAR(rounded.signedDistance, toDouble(exact.signedDistance), bound);
    EXPECT_NEAR(rounded.foot.x, toDouble(exact.foot.x), bound);
    EXPECT_NEAR(rounded.foot.y, toDouble(exact.foot.y), bound);
    EXPECT_NEAR(rounded.foot.z, toDouble(exact.foot.z), bound);
  }
}

} // namespace
} // namespace halfspace
