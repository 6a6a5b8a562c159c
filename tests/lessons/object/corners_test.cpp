#include "lessons/object/corners.h"

#include "tests/lessons/objects.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using namespace test;

std::vector<ExactVec3> placesOf(const Object &object) {
  std::vector<ExactVec3> places;
  for (std::size_t i = 0; i < object.size(); ++i)
    places.push_back(object[i]);
  return places;
}

const ExactVec3 a(0, 0, 0);
const ExactVec3 b(4, 0, 0);
const ExactVec3 c(4, 4, 0);

TEST(Corners, OfAPolygon_AreAddedInTheMiddleOfTheEdgeThatFollows) {
  const Object triangle = objectOf("polygon", {a, b, c});
  EXPECT_EQ(placesOf(withCornerAfter(triangle, 0)), (std::vector<ExactVec3>{a, {2, 0, 0}, b, c}));
  EXPECT_EQ(placesOf(withCornerAfter(triangle, 2)), (std::vector<ExactVec3>{a, b, c, {2, 2, 0}}));
}

TEST(Corners, OfAPrism_AreThoseOfItsBaseBesideTheArrow) {
  const ExactVec3 up(0, 0, 5);
  const Object prism = objectOf("prism", {a, up, b, c});
  EXPECT_EQ(cornersOf(prism), (std::vector<std::size_t>{0, 2, 3}));
  EXPECT_FALSE(canAddCornerAfter(prism, 1)) << "the arrow is none";
  const Object more = withCornerAfter(prism, 0);
  EXPECT_EQ(placesOf(more), (std::vector<ExactVec3>{a, up, {2, 0, 0}, b, c}));
  EXPECT_EQ(placesOf(withoutCorner(more, 0)), (std::vector<ExactVec3>{{2, 0, 0}, up, b, c}));
}

TEST(Corners, AddedAndTakenAwayAgain_LeaveTheObjectAsItWas) {
  const Object triangle = objectOf("polygon", {a, b, c});
  for (std::size_t corner = 0; corner < 3; ++corner)
    EXPECT_EQ(withoutCorner(withCornerAfter(triangle, corner), corner + 1), triangle);
}

TEST(Corners, AreThreeToEight) {
  Object polygon = objectOf("polygon", {a, b, c});
  EXPECT_FALSE(canRemoveCorner(polygon, 0));
  while (canAddCornerAfter(polygon, 0))
    polygon = withCornerAfter(polygon, 0);
  EXPECT_EQ(polygon.size(), 8U);
  EXPECT_TRUE(canRemoveCorner(polygon, 7));
  EXPECT_FALSE(canRemoveCorner(polygon, 8));
}

TEST(Corners, OfATriangleOrABox_StayAsManyAsTheyAre) {
  for (const std::string_view kind : {"triangle", "tetrahedron", "box", "point"}) {
    EXPECT_TRUE(cornersOf(*makeObject(kind)).empty()) << kind;
    EXPECT_FALSE(canAddCornerAfter(*makeObject(kind), 0)) << kind;
    EXPECT_FALSE(canRemoveCorner(*makeObject(kind), 0)) << kind;
  }
}

} // namespace
} // namespace halfspace
