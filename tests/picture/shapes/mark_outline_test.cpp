// The bare lines and faces of each kind of mark.
#include "widgets/picture/shapes/mark_outline.h"

#include "tests/picture/marks.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace halfspace {
namespace {

using Kind = MarkOutline::Kind;

constexpr double rounding = 1e-9;
const Place center(1, 2, 3);

ArcMark arcBetween(Place from, Place to) {
  ArcMark arc;
  arc.center = center;
  arc.from = from;
  arc.to = to;
  return arc;
}

RightAngleMark cornerBetween(Place first, Place second) {
  RightAngleMark corner;
  corner.at = center;
  corner.first = first;
  corner.second = second;
  return corner;
}

SphereMark sphereOf(double radius) {
  SphereMark sphere;
  sphere.center = center;
  sphere.radius = radius;
  return sphere;
}

std::vector<Place> pathOf(const Mark &mark, double size = 1) { return outlineOf(mark, size).path; }

double lengthOf(const std::vector<Place> &path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += glm::distance(path[i - 1], path[i]);
  return length;
}

TEST(Outline, OfAnArc_GoesAroundItsCentreFromOneDirectionToTheOther) {
  const auto path = pathOf(arcBetween({0, 0, 7}, {0, 2, 0}));
  const double radius = glm::distance(path.front(), center);
  EXPECT_NEAR(glm::distance(path.front(), center + Place(0, 0, radius)), 0, rounding);
  EXPECT_NEAR(glm::distance(path.back(), center + Place(0, radius, 0)), 0, rounding);
  for (const Place &place : path) {
    EXPECT_NEAR(glm::distance(place, center), radius, rounding);
    EXPECT_EQ(place.x, center.x) << "it stays in the plane of both";
  }
  EXPECT_NEAR(lengthOf(path), radius * std::numbers::pi / 2, 0.01 * radius);
  EXPECT_NEAR(glm::distance(pathOf(arcBetween({0, 0, 1}, {0, 1, 0})).front(), center), radius, rounding)
      << "however long the directions are";
}

TEST(Outline, OfAnArcAtTwiceTheSize_IsTwiceAsLarge) {
  const ArcMark arc = arcBetween({1, 0, 0}, {0, 1, 1});
  EXPECT_NEAR(lengthOf(pathOf(arc, 2)), 2 * lengthOf(pathOf(arc, 1)), rounding);
}

struct StraightAngles : testing::TestWithParam<Place> {};

TEST_P(StraightAngles, OfAnyDirection_AreHalfACircle) {
  const auto path = pathOf(arcBetween(GetParam(), -GetParam()));
  ASSERT_FALSE(path.empty());
  const double radius = glm::distance(path.front(), center);
  EXPECT_NEAR(lengthOf(path), radius * std::numbers::pi, 0.01 * radius);
  EXPECT_NEAR(glm::distance(path.front(), path.back()), 2 * radius, rounding);
}

INSTANTIATE_TEST_SUITE_P(Directions, StraightAngles,
                         testing::Values(Place(1, 0, 0), Place(0, 0, 3), Place(0, 0, -3), Place(1, 2, 2)));

TEST(Outline, OfARightAngle_IsASquaresTwoFarSides) {
  const auto path = pathOf(cornerBetween({0, 9, 0}, {0, 0, 0.1}), 0.5);
  EXPECT_EQ(path, (std::vector<Place>{center + Place(0, 0.5, 0), center + Place(0, 0.5, 0.5),
                                      center + Place(0, 0, 0.5)}));
}

TEST(Outline, OfABall_IsThreeOfItsGreatCircles) {
  const auto path = pathOf(sphereOf(4));
  Place low(1e9);
  Place high(-1e9);
  for (const Place &place : path) {
    EXPECT_NEAR(glm::distance(place, center), 4, rounding);
    low = glm::min(low, place);
    high = glm::max(high, place);
  }
  EXPECT_NEAR(glm::distance(low, center - Place(4)), 0, rounding);
  EXPECT_NEAR(glm::distance(high, center + Place(4)), 0, rounding);
  EXPECT_NEAR(lengthOf(path), 3.25 * 2 * std::numbers::pi * 4, 0.1) << "and a quarter to get to the third";
}

TEST(Outline, OfWhatHasNoExtent_IsEmpty) {
  EXPECT_TRUE(pathOf(sphereOf(0)).empty());
  EXPECT_TRUE(pathOf(sphereOf(std::nan(""))).empty());
  EXPECT_TRUE(pathOf(arcBetween({0, 0, 0}, {1, 0, 0})).empty());
  EXPECT_TRUE(pathOf(arcBetween({1, 0, 0}, {0, 0, 0})).empty());
  EXPECT_TRUE(pathOf(cornerBetween({0, 0, 0}, {1, 0, 0})).empty());
  EXPECT_TRUE(pathOf(patchAt(center, {0, 0, 0})).empty());
}

TEST(Outline, WithAPlaceThatIsNotFinite_IsEmpty) {
  const double endless = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(pathOf(segmentBetween({0, 0, 0}, {0, endless, 0})).empty());
  EXPECT_TRUE(pathOf(polygonOf({{0, 0, 0}, {1, 0, 0}, {0, std::nan(""), 0}})).empty());
}

TEST(Outline, OfEachKind_IsAPointALineOrAFace) {
  EXPECT_EQ(outlineOf(pointAt(center), 1).kind, Kind::Point);
  EXPECT_EQ(outlineOf(segmentBetween({0, 0, 0}, center), 1).kind, Kind::Line);
  EXPECT_EQ(outlineOf(sphereOf(4), 1).kind, Kind::Line);
  EXPECT_EQ(outlineOf(patchAt(center, {0, 0, 1}), 1).kind, Kind::Face);
  EXPECT_EQ(outlineOf(polygonOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 1).kind, Kind::Face);
}

TEST(Outline, OfAnArrowDrawnAtAnotherLength_EndsThere) {
  ArrowMark arrow;
  arrow.from = center;
  arrow.vector = {0, 0, 100};
  arrow.drawnLength = 3;
  EXPECT_EQ(pathOf(arrow), (std::vector<Place>{center, center + Place(0, 0, 3)}));
}

} // namespace
} // namespace halfspace
