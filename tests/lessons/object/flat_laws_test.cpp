// What holds of all flats: points, lines and planes with numbers that mean nothing.
#include "lessons/object/flat.h"

#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace halfspace {
namespace {

constexpr int cases = 60;

/// A point, a line, a plane or all of space (0 to 3), through a place.
Flat anyFlat(RandomNumbers &random, std::size_t dimension, const ExactVec3 &through) {
  switch (dimension) {
  case 0:
    return Flat::point(through);
  case 1:
    return Flat::line(through, random.nonZeroVector(5));
  case 2:
    return Flat::plane(through, random.nonZeroVector(5));
  default:
    return {};
  }
}

Rational squareOf(const ExactVec3 &v) { return dot(v, v); }

struct EveryDimension : testing::TestWithParam<std::size_t> {};

TEST_P(EveryDimension, NearestPlaces_LieOnTheFlatAndNoOtherIsNearer) {
  RandomNumbers random(GetParam());
  for (int i = 0; i < cases; ++i) {
    const Flat flat = anyFlat(random, GetParam(), random.vector());
    ASSERT_EQ(flat.dimension(), GetParam());
    const ExactVec3 place = random.vector();
    const ExactVec3 nearest = flat.nearest(place);
    EXPECT_TRUE(flat.contains(nearest));
    EXPECT_EQ(flat.nearest(nearest), nearest);
    const ExactVec3 other = flat.nearest(random.vector());
    EXPECT_EQ(dot(place - nearest, other - nearest), 0) << "the way to it is perpendicular";
    EXPECT_LE(squareOf(place - nearest), squareOf(place - other));
  }
}

TEST_P(EveryDimension, ThatMovesAlongAnAxis_HasPlacesWithOtherCoordinates) {
  RandomNumbers random(10 + GetParam());
  for (int i = 0; i < cases; ++i) {
    const Flat flat = anyFlat(random, GetParam(), random.vector());
    for (int axis = 0; axis < 3; ++axis) {
      bool moves = false;
      const ExactVec3 first = flat.nearest(ExactVec3(0));
      for (int k = 0; k < 3; ++k) {
        ExactVec3 aside(0);
        aside[k] = 7;
        moves = moves || flat.nearest(aside)[axis] != first[axis];
      }
      EXPECT_EQ(flat.moves(axis), moves) << "xyz"[axis];
    }
  }
}

TEST_P(EveryDimension, MetByAnotherInAPlace_IsMetThereAlsoTheOtherWayRound) {
  RandomNumbers random(20 + GetParam());
  for (int i = 0; i < cases; ++i) {
    const ExactVec3 common = random.vector();
    const Flat flat = anyFlat(random, GetParam(), common);
    for (std::size_t dimension = 0; dimension <= 3; ++dimension) {
      const Flat other = anyFlat(random, dimension, common);
      const auto meeting = Flat::intersection(flat, other);
      const auto reversed = Flat::intersection(other, flat);
      ASSERT_TRUE(meeting && reversed);
      EXPECT_TRUE(meeting->contains(common));
      EXPECT_EQ(meeting->dimension(), reversed->dimension());
      EXPECT_LE(meeting->dimension(), std::min(flat.dimension(), other.dimension()));
      const ExactVec3 place = meeting->nearest(random.vector());
      EXPECT_TRUE(flat.contains(place) && other.contains(place) && reversed->contains(place));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Flats, EveryDimension, testing::Values(0U, 1U, 2U, 3U));

TEST(FlatLaws, PlacesBesideAFlat_AreNoneOfItAndDoNotMeetIt) {
  RandomNumbers random(5);
  for (int i = 0; i < cases; ++i) {
    const ExactVec3 normal = random.nonZeroVector(5);
    const ExactVec3 through = random.vector();
    const Flat plane = Flat::plane(through, normal);
    EXPECT_FALSE(plane.contains(through + normal));
    EXPECT_FALSE(Flat::intersection(plane, Flat::point(through + normal)));
    EXPECT_FALSE(Flat::intersection(plane, Flat::plane(through + normal, normal * Rational(-2))));
    const ExactVec3 inside = cross(normal, random.nonZeroVector(5));
    if (!isZero(inside)) {
      EXPECT_FALSE(Flat::intersection(plane, Flat::line(through + normal, inside))) << "parallel to it";
    }
  }
}

TEST(FlatLaws, LinesAlongTheAxes_MoveAlongThemAlone) {
  for (int axis = 0; axis < 3; ++axis) {
    ExactVec3 direction(0);
    direction[axis] = -3;
    const Flat line = Flat::line({1, 2, 3}, direction);
    ASSERT_EQ(line.dimension(), 1U);
    for (int other = 0; other < 3; ++other)
      EXPECT_EQ(line.moves(other), other == axis);
    EXPECT_TRUE(isZero(cross(line.direction(), direction)));
  }
}

TEST(FlatLaws, ALineOfTwoPlanes_HasTheirCommonDirection) {
  RandomNumbers random(6);
  for (int i = 0; i < cases; ++i) {
    const ExactVec3 n = random.nonZeroVector(5);
    const ExactVec3 m = random.nonZeroVector(5);
    const ExactVec3 common = random.vector();
    const auto line = Flat::intersection(Flat::plane(common, n), Flat::plane(common, m));
    ASSERT_TRUE(line);
    if (isZero(cross(n, m)))
      continue;
    ASSERT_EQ(line->dimension(), 1U);
    EXPECT_TRUE(isZero(cross(line->direction(), cross(n, m))));
    EXPECT_FALSE(isZero(line->direction()));
  }
}

} // namespace
} // namespace halfspace
