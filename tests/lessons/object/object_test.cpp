// Objects as values: by their kind's words, by its struct, and by their letters.
#include "lessons/object/kinds/number.h"
#include "lessons/object/letters.h"

#include "tests/lessons/object/spelled_objects.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

TEST(Objects, OfAStruct_AreThatStructAgain) {
  const PlaneObject plane{{1, 2, 3}, {0, q(1, 2), 1}};
  EXPECT_EQ(objectAs<PlaneObject>(Object(plane))->normal, plane.normal);
  EXPECT_EQ(objectAs<PlaneObject>(Object(plane))->point, plane.point);
  const NumberObject number{q(1, 2), 0, 3, q(1, 4)};
  EXPECT_EQ(objectAs<NumberObject>(Object(number)), number);
  EXPECT_EQ(Object(number)[3].x, q(1, 4));
}

TEST(Objects, OfAnotherKind_AreNoStructOfThisOne) {
  EXPECT_FALSE(objectAs<LineObject>(Object(RayObject{{1, 2, 3}, {0, 0, 1}})));
  EXPECT_NE(Object(LineObject{{1, 2, 3}, {0, 0, 1}}), Object(RayObject{{1, 2, 3}, {0, 0, 1}}));
}

TEST(Objects, MadeByAWord_HaveTheFewestCoordinatesAllZero) {
  for (const Kind &kind : kinds()) {
    const auto object = makeObject(kind.word);
    ASSERT_TRUE(object) << kind.word;
    EXPECT_EQ(object->size(), kind.fewestCoordinates());
    for (std::size_t i = 0; i < object->size(); ++i)
      EXPECT_EQ((*object)[i], ExactVec3(0));
  }
  EXPECT_FALSE(makeObject("Plane")) << "words are small";
  EXPECT_FALSE(makeObject(""));
  EXPECT_EQ(Object(), Object(PointObject{{0, 0, 0}}));
}

TEST(Objects, WithMoreVertices_NameThemOn) {
  const Object polygon = spelledObject("polygon");
  ASSERT_EQ(polygon.size(), 4U);
  EXPECT_EQ(coordinatesOf(polygon).back().name, "P3");
  EXPECT_NE(polygon, spelledObject("triangle"));
}

TEST(Coordinates, OfEachRole_AreAsManyNumbersAsTheyNeed) {
  EXPECT_EQ(numbersIn(CoordinateRole::Position), 3);
  EXPECT_EQ(numbersIn(CoordinateRole::Direction), 3);
  EXPECT_EQ(numbersIn(CoordinateRole::Length), 1);
  EXPECT_EQ(numbersIn(CoordinateRole::Number), 1);
  EXPECT_THROW((void)spelledObject("point")[1], std::out_of_range);
}

TEST(Coordinates, OfNumbersAndPoints_GoByTheObjectsName) {
  const Scene scene =
      spelledScene("{name: k, number: {value: 1, from: 0, to: 3, step: 1}}, " + spelledEntry("point"));
  EXPECT_EQ(findCoordinate(scene, "k"), (CoordinateId{"k", 0}));
  EXPECT_EQ(findCoordinate(scene, "K"), (CoordinateId{"K", 0}));
  EXPECT_EQ(findCoordinate(scene, "k.to"), (CoordinateId{"k", 2}));
}

TEST(EdgeName, OfLetters_SaysWhoseTheyAreWhereThatMatters) {
  EXPECT_EQ(edgeName(letter("P", "0"), letter("P", "1")), "P₀P₁");
  Symbol owned = letter("P", "0");
  owned.owner = "T";
  Symbol other = letter("P", "1");
  other.owner = "T";
  const std::string name = edgeName(owned, other);
  EXPECT_NE(name.find(" to "), std::string::npos) << name;
  EXPECT_NE(name.find("T"), std::string::npos) << name;
}

TEST(IsUnit, OfVectors_IsDecidedExactly) {
  const auto vector = [](const ExactVec3 &v) { return given(vectorLetter("n"), v, "E", 1); };
  EXPECT_TRUE(isUnit(vector({0, 0, -1})));
  EXPECT_TRUE(isUnit(vector({q(1, 3), q(2, 3), q(2, 3)})));
  EXPECT_FALSE(isUnit(vector({0, 0, 0})));
  EXPECT_FALSE(isUnit(vector({0, 0, 1 + powerOfTen(-30)})));
}

TEST(VectorOf, ATerm_IsTheExactVectorItComesTo) {
  const Term n = given(vectorLetter("n"), {1, q(1, 3), -2}, "E", 1);
  EXPECT_EQ(vectorOf(n), ExactVec3(1, q(1, 3), -2));
  EXPECT_EQ(vectorOf(n + n), ExactVec3(2, q(2, 3), -4));
  EXPECT_EQ(vectorOf(cross(n, n)), ExactVec3(0));
}

TEST(Equation, OfAName_IsItsValueMarkedAsRoundedWhereItIs) {
  EXPECT_EQ(equation(name(letter("t"), Rational(-10, 3))), "t = −10/3");
  const std::string rounded = equation(name(letter("t"), Rational(271828182846, 1000000000000)));
  EXPECT_NE(rounded.find("≈"), std::string::npos) << rounded;
}

} // namespace
} // namespace halfspace
