#include "geometry/integer.h"
#include "geometry/plane.h"
#include "geometry/point_plane.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

namespace halfspace {
namespace {

using Coefficients = std::array<Rational, 4>;

const Plane<Rational> notesPlane = planeThrough(ExactVec3(5, 4, 7), ExactVec3(1, 2, 2));

std::vector<std::string> textsOf(const std::array<Surd, 4> &values) {
  std::vector<std::string> texts(values.size());
  std::transform(values.begin(), values.end(), texts.begin(),
                 [](const Surd &value) { return toText(value).value_or("?"); });
  return texts;
}

TEST(PlaneThrough, NotesExample_IsXPlus2YPlus2ZMinus27) {
  EXPECT_EQ(notesPlane.normal, ExactVec3(1, 2, 2));
  EXPECT_EQ(notesPlane.offset, -27);
}

TEST(PlaneThrough, AnyPointOfThePlane_GivesTheSameOffset) {
  RandomNumbers random(21);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 point = random.vector();
    const ExactVec3 normal = random.nonZeroVector();
    const Plane<Rational> plane = planeThrough(point, normal);
    const ExactVec3 other = point + cross(normal, random.vector());
    EXPECT_EQ(evaluate(plane, point), 0); // law (1)
    EXPECT_EQ(evaluate(plane, other), 0);
    EXPECT_EQ(planeThrough(other, normal).offset, plane.offset); // law (2)
    EXPECT_EQ(evaluate(plane, ExactVec3(other + normal)), dot(normal, normal));
  }
}

TEST(PlaneThrough, ThreePoints_LieInItAndTurnItByTheirOrder) {
  RandomNumbers random(182);
  for (int i = 0; i < test::effort(2000); ++i) {
    const ExactVec3 p = random.wholeVector(2);
    const ExactVec3 q = random.wholeVector(2);
    const ExactVec3 r = i % 3 == 0 ? ExactVec3(p + (q - p) * random.rational(2)) : random.wholeVector(2);
    const auto plane = planeThrough(p, q, r);
    for (const ExactVec3 &point : {p, q, r})
      EXPECT_EQ(evaluate(plane, point), 0); // law (1)
    const auto turned = planeThrough(q, r, p);
    EXPECT_EQ(turned.normal, plane.normal); // law (2)
    EXPECT_EQ(turned.offset, plane.offset);
    const auto swapped = planeThrough(p, r, q);
    EXPECT_EQ(swapped.normal, ExactVec3(-plane.normal));
    EXPECT_EQ(swapped.offset, -plane.offset);
    if (isZero(plane.normal)) { // law (3)
      EXPECT_TRUE(p == q || r == p + (q - p) * Rational(dot(ExactVec3(r - p), ExactVec3(q - p)) /
                                                        dot(ExactVec3(q - p), ExactVec3(q - p))));
      EXPECT_EQ(plane.offset, 0);
    }
    EXPECT_TRUE(i % 3 != 0 || isZero(plane.normal));
  }
}

TEST(PlaneThrough, PointsCounterclockwiseFromAbove_HaveAbovePositive) {
  const auto plane = planeThrough(ExactVec3(0, 0, 0), ExactVec3(1, 0, 0), ExactVec3(0, 1, 0));
  EXPECT_EQ(evaluate(plane, ExactVec3(0, 0, 1)), 1);
}

TEST(Evaluate, PointMovedAndPlaneMultiplied_GrowsWithBoth) {
  RandomNumbers random(183);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Plane<Rational> plane{random.vector(), random.rational()};
    const ExactVec3 x = random.vector();
    const ExactVec3 v = random.vector();
    EXPECT_EQ(evaluate(plane, ExactVec3(x + v)), evaluate(plane, x) + dot(plane.normal, v)); // law (1)
    const Rational k = random.rational();
    EXPECT_EQ(evaluate(Plane<Rational>{plane.normal * k, Rational(plane.offset * k)}, x),
              evaluate(plane, x) * k); // law (2)
  }
}

TEST(Evaluate, NotesExample_Is30AtQ) {
  EXPECT_EQ(evaluate(notesPlane, ExactVec3(11, 15, 8)), 30);
  EXPECT_EQ(evaluate(notesPlane, ExactVec3(5, 4, 7)), 0);
  EXPECT_EQ(evaluate(notesPlane, ExactVec3(0, 0, 0)), -27);
}

TEST(NormalizedCoefficients, NotesExample_AreThirds) {
  EXPECT_EQ(textsOf(normalizedCoefficients(notesPlane)),
            (std::vector<std::string>{"1/3", "2/3", "2/3", "-9"}));
}

TEST(NormalizedCoefficients, LengthThatIsNoFraction_KeepsItsRoot) {
  const Plane<Rational> plane{ExactVec3(1, -1, 0), 3};
  EXPECT_EQ(textsOf(normalizedCoefficients(plane)),
            (std::vector<std::string>{"1/2*sqrt(2)", "-1/2*sqrt(2)", "0", "3/2*sqrt(2)"}));
}

TEST(NormalizedCoefficients, Multiples_GiveTheSameOrTheNegatives) { // law (2)
  RandomNumbers random(22);
  for (int i = 0; i < test::effort(500); ++i) {
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const Rational k = random.nonZeroRational();
    const Plane<Rational> scaled{plane.normal * k, Rational(plane.offset * k)};
    auto expected = normalizedCoefficients(plane);
    if (k < 0)
      std::transform(expected.begin(), expected.end(), expected.begin(), std::negate());
    EXPECT_EQ(normalizedCoefficients(scaled), expected);
  }
}

TEST(NormalizedCoefficients, PutIntoThePlanesForm_GiveTheSignedDistance) { // law (3)
  // All of them are multiples of one root, 1/|n|.
  const auto share = [](const Surd &value) {
    return value.isRational() ? value.rationalPart() : value.rootFactor();
  };
  RandomNumbers random(184);
  for (int i = 0; i < test::effort(500); ++i) {
    const Plane<Rational> plane{random.nonZeroWholeVector(9), random.integer(-9, 9)};
    const ExactVec3 x = random.wholeVector(9);
    const auto [a, b, c, d] = normalizedCoefficients(plane);
    EXPECT_EQ(share(a) * x.x + share(b) * x.y + share(c) * x.z + share(d),
              share(measurePointPlane(x, plane).signedDistance));
  }
}

TEST(NormalizedCoefficients, Normal_HasLengthOne) { // law (1)
  RandomNumbers random(23);
  for (int i = 0; i < test::effort(500); ++i) {
    const auto normalized =
        normalizedCoefficients(Plane<Rational>{random.nonZeroVector(), random.rational()});
    Rational square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Surd &part = normalized[axis];
      square +=
          part.rationalPart() * part.rationalPart() + part.rootFactor() * part.rootFactor() * part.radicand();
    }
    EXPECT_EQ(square, 1);
  }
}

TEST(PrimitiveCoefficients, FractionsAndCommonFactors_BecomeSmallestIntegers) {
  EXPECT_EQ(primitiveCoefficients(notesPlane), (Coefficients{1, 2, 2, -27}));
  EXPECT_EQ(primitiveCoefficients({ExactVec3(Rational(1, 2), Rational(-1, 3), 0), Rational(5, 6)}),
            (Coefficients{3, -2, 0, 5}));
  EXPECT_EQ(primitiveCoefficients({ExactVec3(-4, 6, -8), 10}), (Coefficients{-2, 3, -4, 5}));
  EXPECT_EQ(primitiveCoefficients({ExactVec3(0, 0, -7), 0}), (Coefficients{0, 0, -1, 0}));
}

TEST(PrimitiveCoefficients, PositiveMultiples_GiveTheSameAndNegativeOnesTheOpposite) {
  RandomNumbers random(24);
  for (int i = 0; i < test::effort(2000); ++i) {
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const Rational k = random.nonZeroRational();
    const Coefficients primitive = primitiveCoefficients(plane);
    const Coefficients scaled = primitiveCoefficients({plane.normal * k, Rational(plane.offset * k)});
    const std::array given{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
    for (std::size_t j = 0; j < primitive.size(); ++j) {
      EXPECT_EQ(scaled[j], primitive[j] * k.sign());   // law (3)
      EXPECT_EQ(primitive[j].sign(), given[j].sign()); // law (1)
      EXPECT_EQ(primitive[j] * given[0], primitive[0] * given[j]);
    }
    Integer common = 0;
    for (const Rational &whole : primitive)
      common = mp::gcd(common, integerOf(whole));
    EXPECT_EQ(common, 1); // law (2)
  }
}

} // namespace
} // namespace halfspace
