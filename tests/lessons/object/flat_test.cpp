#include "lessons/object/flat.h"

#include "tests/lessons/scenes.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using test::q;

TEST(Flat, TheNearestPlaceOfAPlane_IsTheFoot) {
  const Flat plane = Flat::plane({5, 4, 7}, {1, 2, 2});
  EXPECT_EQ(plane.dimension(), 2U);
  const ExactVec3 foot = plane.nearest({11, 15, 8});
  EXPECT_EQ(foot, ExactVec3(q(23, 3), q(25, 3), q(4, 3)));
  EXPECT_TRUE(plane.contains(foot));
}

TEST(Flat, TheNearestPlaceOfALine_IsThePerpendicularsFoot) {
  const Flat line = Flat::line({0, 0, 0}, {1, 1, 0});
  EXPECT_EQ(line.dimension(), 1U);
  EXPECT_EQ(line.nearest({1, 0, 5}), ExactVec3(q(1, 2), q(1, 2), 0));
  EXPECT_TRUE(isZero(cross(line.direction(), ExactVec3(1, 1, 0))));
}

TEST(Flat, APoint_ContainsItselfAlone) {
  const Flat point = Flat::point({1, 2, 3});
  EXPECT_EQ(point.dimension(), 0U);
  EXPECT_TRUE(point.contains({1, 2, 3}));
  EXPECT_EQ(point.nearest({9, 9, 9}), ExactVec3(1, 2, 3));
}

TEST(Flat, Intersections_AreWhatTheyHaveInCommonOrNothing) {
  const Flat ground = Flat::plane({0, 0, 0}, {0, 0, 1});
  const auto line = Flat::intersection(ground, Flat::plane({0, 0, 0}, {0, 1, 1}));
  ASSERT_TRUE(line);
  EXPECT_EQ(line->dimension(), 1U);
  const auto point = Flat::intersection(*line, Flat::plane({3, 0, 0}, {1, 1, 1}));
  ASSERT_TRUE(point);
  EXPECT_EQ(point->nearest({0, 0, 0}), ExactVec3(3, 0, 0));
  EXPECT_FALSE(Flat::intersection(ground, Flat::plane({0, 0, 1}, {0, 0, 2})));
  EXPECT_EQ(Flat::intersection(ground, Flat::plane({5, 5, 0}, {0, 0, -3}))->dimension(), 2U);
}

TEST(Flat, MovesOnlyAlongItsOwnAxes) {
  const Flat ground = Flat::plane({0, 0, 3}, {0, 0, 7});
  EXPECT_TRUE(ground.moves(0) && ground.moves(1));
  EXPECT_FALSE(ground.moves(2));
  const Flat upright = Flat::line({1, 1, 1}, {0, 0, 2});
  EXPECT_FALSE(upright.moves(0) || upright.moves(1));
  EXPECT_TRUE(upright.moves(2));
}

} // namespace
} // namespace halfspace
