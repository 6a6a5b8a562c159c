// Objects as things in space.
#include "lessons/discovery/spatial_object.h"
#include "tests/lessons/objects.h"
#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using test::objectOf;

SpatialObject spatial(std::string_view kind, const std::vector<ExactVec3> &coordinates) {
  return spatialOf(objectOf(kind, coordinates)).value();
}

SpatialObject lineOf(const ExactVec3 &at, const ExactVec3 &way) { return spatial("line", {at, way}); }

TEST(SpatialObject, OfADegenerateObject_IsNone) {
  EXPECT_FALSE(spatialOf(objectOf("plane", {{1, 2, 3}, {0, 0, 0}})));
  EXPECT_FALSE(spatialOf(objectOf("line", {{1, 2, 3}, {0, 0, 0}})));
  EXPECT_FALSE(spatialOf(objectOf("segment", {{1, 2, 3}, {1, 2, 3}})));
  EXPECT_FALSE(spatialOf(objectOf("triangle", {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}})));
  EXPECT_FALSE(spatialOf(objectOf("polygon", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 1}})))
      << "it is not flat";
  EXPECT_FALSE(spatialOf(objectOf("sphere", {{0, 0, 0}, {0, 0, 0}})));
  EXPECT_FALSE(spatialOf(objectOf("box", {{0, 0, 0}}))) << "boxes have no form";
  EXPECT_FALSE(lineThrough(spatial("point", {{1, 2, 3}}), spatial("point", {{1, 2, 3}})));
}

TEST(SpatialObject, ParallelAndPerpendicular_OfLinesAndPlanes) {
  const SpatialObject up = lineOf({5, 5, 5}, {0, 0, 2});
  const SpatialObject across = lineOf({0, 0, 0}, {3, 4, 0});
  const SpatialObject ground = spatial("plane", {{0, 0, 0}, {0, 0, -1}});
  const SpatialObject wall = spatial("triangle", {{0, 0, 0}, {3, 4, 0}, {0, 0, 1}});
  EXPECT_TRUE(arePerpendicular(up, across));
  EXPECT_TRUE(arePerpendicular(up, ground));
  EXPECT_TRUE(areParallel(across, ground));
  EXPECT_TRUE(arePerpendicular(wall, ground));
  EXPECT_TRUE(areParallel(up, wall));
  EXPECT_FALSE(areParallel(up, ground));
  EXPECT_FALSE(areParallel(wall, ground));
}

TEST(SpatialObject, Contains_WhatLiesOnIt) {
  const SpatialObject line = lineOf({1, 0, 0}, {1, 1, 0});
  EXPECT_TRUE(contains(line, ExactVec3(-1, -2, 0)));
  EXPECT_FALSE(contains(line, ExactVec3(0, 0, 0)));
  EXPECT_TRUE(contains(spatial("plane", {{0, 0, 0}, {1, -1, 0}}), ExactVec3(7, 7, 1)));
  EXPECT_TRUE(contains(spatial("sphere", {{1, 1, 1}, {3, 0, 0}}), ExactVec3(2, 3, 3)));
  EXPECT_FALSE(contains(spatial("sphere", {{1, 1, 1}, {3, 0, 0}}), ExactVec3(1, 1, 1)));
  EXPECT_TRUE(contains(spatial("plane", {{0, 0, 0}, {0, 0, 1}}), line));
  EXPECT_FALSE(contains(spatial("plane", {{0, 0, 1}, {0, 0, 1}}), line));
}

TEST(SpatialObject, SquaredDistance_IsExact) {
  EXPECT_EQ(squaredDistance({1, 2, 3}, spatial("point", {{1, 0, 0}})), 13);
  EXPECT_EQ(squaredDistance({0, 0, 1}, lineOf({0, 0, 0}, {1, 0, 1})), test::q(1, 2));
  EXPECT_EQ(squaredDistance({0, 0, 1}, spatial("plane", {{0, 0, 0}, {1, 1, 1}})), test::q(1, 3));
}

TEST(SpatialObject, MeetingPoint_IsTheOneOfTwoLines) {
  EXPECT_EQ(meetingPoint(lineOf({0, 0, 0}, {1, 1, 0}), lineOf({4, 0, 0}, {-1, 1, 0})), ExactVec3(2, 2, 0));
  EXPECT_FALSE(meetingPoint(lineOf({0, 0, 0}, {1, 1, 0}), lineOf({4, 0, 1}, {-1, 1, 0})));
  EXPECT_FALSE(meetingPoint(lineOf({0, 0, 0}, {1, 1, 0}), lineOf({0, 0, 0}, {2, 2, 0})));
}

} // namespace
} // namespace halfspace
