#include "geometry/triangle.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace halfspace {
namespace {

/// Every order of three.
std::vector<std::array<std::size_t, 3>> orders() {
  std::vector<std::array<std::size_t, 3>> all;
  std::array<std::size_t, 3> order{0, 1, 2};
  do
    all.push_back(order);
  while (std::next_permutation(order.begin(), order.end()));
  return all;
}

TEST(TriangleShape, AnyCorners_AreProperExactlyWithANormalAndTheSameInAnyOrder) {
  RandomNumbers random(173);
  std::map<TriangleShape, int> shapes;
  for (int i = 0; i < 3000; ++i) {
    const std::array<ExactVec3, 3> corners{random.wholeVector(1), random.wholeVector(1),
                                           random.wholeVector(1)};
    const TriangleShape shape = shapeOf<Rational>({corners[0], corners[1], corners[2]});
    ++shapes[shape];
    const ExactVec3 normal = cross(ExactVec3(corners[1] - corners[0]), ExactVec3(corners[2] - corners[0]));
    EXPECT_EQ(shape == TriangleShape::Proper, !isZero(normal)); // law (1)
    for (const auto &[first, second, third] : orders())         // law (2)
      EXPECT_EQ(shapeOf<Rational>({corners[first], corners[second], corners[third]}), shape);
  }
  EXPECT_EQ(shapes.size(), 3U) << "a shape did not come up";
}

TEST(PointOf, CornersAndSwappedCorners_AreWhereTheirParametersSay) {
  RandomNumbers random(174);
  for (int i = 0; i < test::effort(500); ++i) {
    const Triangle<Rational> triangle{random.vector(), random.vector(), random.vector()};
    const Rational zero = 0;
    const Rational one = 1;
    EXPECT_EQ(pointOf(triangle, zero, zero), triangle.p0); // law (1)
    EXPECT_EQ(pointOf(triangle, one, zero), triangle.p1);
    EXPECT_EQ(pointOf(triangle, zero, one), triangle.p2);
    const Rational s = random.rational(2);
    const Rational t = random.rational(2);
    const Triangle<Rational> swapped{triangle.p0, triangle.p2, triangle.p1};
    EXPECT_EQ(pointOf(swapped, t, s), pointOf(triangle, s, t)); // law (2)
  }
}

TEST(IsInParallelogram, AnyParameters_AreInOneOfItsTwoTriangles) { // law (1)
  for (int s = -2; s <= 6; ++s)
    for (int t = -2; t <= 6; ++t) {
      const Rational u(s, 4);
      const Rational v(t, 4);
      const bool inHalf = locationInTriangle(u, v).part != FacePart::Outside;
      const bool inOther = locationInTriangle(Rational(1 - u), Rational(1 - v)).part != FacePart::Outside;
      EXPECT_EQ(isInParallelogram(u, v), inHalf || inOther) << s << "/4, " << t << "/4";
    }
}

TEST(LocationBySigns, AnySignsInAnyOrder_GiveTheSameLocationByItsNewIndex) {
  for (int code = 0; code < 27; ++code) {
    const std::array<int, 3> signs{code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1};
    if (signs == std::array{0, 0, 0})
      continue;
    const FaceLocation location = locationBySigns(signs);
    EXPECT_EQ(location.part == FacePart::Outside,
              std::find(signs.begin(), signs.end(), -1) != signs.end()); // law (1)
    for (const auto &order : orders()) {                                 // law (2)
      const FaceLocation moved = locationBySigns({signs[order[0]], signs[order[1]], signs[order[2]]});
      EXPECT_EQ(moved.part, location.part);
      const auto feature =
          moved.feature < 0 ? -1 : static_cast<int>(order[static_cast<std::size_t>(moved.feature)]);
      EXPECT_EQ(feature, location.feature);
    }
  }
}

TEST(LocationInTriangle, AnyParameters_AreOutsideByTheThreeInequalitiesAndSwapTheirFeatures) {
  for (int s = -2; s <= 6; ++s)
    for (int t = -2; t <= 6; ++t) {
      const Rational u(s, 4);
      const Rational v(t, 4);
      const FaceLocation location = locationInTriangle(u, v);
      EXPECT_EQ(location.part == FacePart::Outside, s < 0 || t < 0 || s + t > 4); // law (1)
      const FaceLocation swapped = locationInTriangle(v, u);                      // law (2)
      EXPECT_EQ(swapped.part, location.part);
      EXPECT_EQ(swapped.feature, location.feature < 1 ? location.feature : 3 - location.feature);
    }
}

} // namespace
} // namespace halfspace
