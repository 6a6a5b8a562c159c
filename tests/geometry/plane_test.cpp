#include "geometry/plane.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

using Coefficients = std::array<Integer, 4>;

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
  for (int i = 0; i < 2000; ++i) {
    const ExactVec3 point = random.vector();
    const ExactVec3 normal = random.nonZeroVector();
    const Plane<Rational> plane = planeThrough(point, normal);
    const ExactVec3 other = point + cross(normal, random.vector());
    EXPECT_EQ(evaluate(plane, other), 0);
    EXPECT_EQ(planeThrough(other, normal).offset, plane.offset);
    EXPECT_EQ(evaluate(plane, ExactVec3(other + normal)), dot(normal, normal));
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

TEST(NormalizedCoefficients, PositiveMultiples_GiveTheSame) {
  RandomNumbers random(22);
  for (int i = 0; i < 500; ++i) {
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const Rational k = abs(random.nonZeroRational());
    const Plane<Rational> scaled{plane.normal * k, Rational(plane.offset * k)};
    EXPECT_EQ(normalizedCoefficients(scaled), normalizedCoefficients(plane));
  }
}

TEST(NormalizedCoefficients, Normal_HasLengthOne) {
  RandomNumbers random(23);
  for (int i = 0; i < 500; ++i) {
    const auto normalized =
        normalizedCoefficients(Plane<Rational>{random.nonZeroVector(), random.rational()});
    Rational square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Surd &part = normalized[axis];
      square += part.rationalPart() * part.rationalPart() +
                part.rootFactor() * part.rootFactor() * Rational(part.radicand());
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
  for (int i = 0; i < 2000; ++i) {
    const Plane<Rational> plane{random.nonZeroVector(), random.rational()};
    const Rational k = random.nonZeroRational();
    const Coefficients primitive = primitiveCoefficients(plane);
    const Coefficients scaled = primitiveCoefficients({plane.normal * k, Rational(plane.offset * k)});
    for (std::size_t j = 0; j < primitive.size(); ++j)
      EXPECT_EQ(scaled[j], primitive[j] * k.sign());
    EXPECT_EQ(mp::gcd(mp::gcd(primitive[0], primitive[1]), mp::gcd(primitive[2], primitive[3])), 1);
  }
}

} // namespace
} // namespace halfspace
