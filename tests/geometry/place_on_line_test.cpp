#include "geometry/place_on_line.h"

#include "geometry/rational.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Exact = Vec3<Rational>;

TEST(PlaceOnLine, OfAPointBetweenTheEnds_IsTheSegmentWithOneT) {
  const auto place = placeOnLine(Exact(4, 6, 3), Exact(3, 4, 2), Exact(2, 4, 2));
  EXPECT_EQ(place.which, LinePlace::Segment);
  EXPECT_EQ(place.t, Rational(1, 2));
  for (const auto &steps : place.steps)
    EXPECT_EQ(steps, Rational(1, 2));
}

TEST(PlaceOnLine, OfTheEnds_IsTheSegment) {
  EXPECT_EQ(placeOnLine(Exact(1, 2, 3), Exact(1, 2, 3), Exact(2, 0, -5)).which, LinePlace::Segment);
  EXPECT_EQ(placeOnLine(Exact(3, 2, -2), Exact(1, 2, 3), Exact(2, 0, -5)).which, LinePlace::Segment);
}

TEST(PlaceOnLine, BesideTheLine_TellsWhatEachCoordinateAsksFor) {
  const auto place = placeOnLine(Exact(8, 9, 6), Exact(3, 4, 2), Exact(2, 4, 2));
  EXPECT_EQ(place.which, LinePlace::Off);
  EXPECT_EQ(place.steps[0], Rational(5, 2));
  EXPECT_EQ(place.steps[1], Rational(5, 4));
  EXPECT_EQ(place.steps[2], Rational(2));
}

TEST(PlaceOnLine, WhereTheDirectionHasAZero_AsksForEqualityInstead) {
  const auto on = placeOnLine(Exact(5, 2, -1), Exact(5, 4, 3), Exact(0, 1, 2));
  EXPECT_EQ(on.which, LinePlace::Before);
  EXPECT_EQ(on.t, -2);
  EXPECT_FALSE(on.steps[0].has_value());
  const auto off = placeOnLine(Exact(6, 2, -1), Exact(5, 4, 3), Exact(0, 1, 2));
  EXPECT_EQ(off.which, LinePlace::Off);
  EXPECT_EQ(off.steps[1], off.steps[2]);
}

TEST(PlaceOnLine, WithoutADirection_IsToldAsThat) {
  EXPECT_EQ(placeOnLine(Exact(1, 2, 3), Exact(1, 2, 3), Exact(0)).which, LinePlace::ZeroDirection);
}

TEST(PlaceOnLine, OverDoubles_IsTheSame) {
  using Double = Vec3<double>;
  const auto place = placeOnLine(Double(3, 2, 7), Double(1, 2, 3), Double(1, 0, 2));
  EXPECT_EQ(place.which, LinePlace::Beyond);
  EXPECT_EQ(place.t, 2);
}

/// A point of the line at some t, or one beside it.
struct Given {
  Exact through;
  Exact direction;
  Exact point;
};

/// Every second point is on the line; now and then the direction has zeros, or nothing else.
Given anyGiven(RandomNumbers &random) {
  Given given{random.wholeVector(4), random.wholeVector(2), random.wholeVector(4)};
  if (random.integer(0, 1) == 0)
    given.point = given.through + given.direction * random.rational(3);
  return given;
}

/// By the signs of products with the direction, seen from both ends of the segment.
LinePlace placeByProducts(const Given &given) {
  const Exact fromStart = given.point - given.through;
  const Exact fromEnd = fromStart - given.direction;
  if (!isZero(cross(fromStart, given.direction)))
    return LinePlace::Off;
  if (dot(fromStart, given.direction) < 0)
    return LinePlace::Before;
  return dot(fromEnd, given.direction) > 0 ? LinePlace::Beyond : LinePlace::Segment;
}

TEST(PlaceOnLine, OfAnyNumbers_IsWhatProductsOfVectorsSay) {
  RandomNumbers random(121);
  for (int i = 0; i < test::effort(10'000); ++i) {
    const Given given = anyGiven(random);
    const auto place = placeOnLine(given.point, given.through, given.direction);
    if (isZero(given.direction)) {
      EXPECT_EQ(place.which, LinePlace::ZeroDirection);
      continue;
    }
    EXPECT_EQ(place.which, placeByProducts(given)); // law (2)
    if (place.which != LinePlace::Off) {
      EXPECT_EQ(given.point, Exact(given.through + given.direction * place.t)); // law (1)
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto &steps = place.steps.at(static_cast<std::size_t>(axis));
      EXPECT_EQ(steps.has_value(), given.direction[axis] != 0);
      if (steps) {
        EXPECT_EQ(Rational(given.through[axis] + *steps * given.direction[axis]), given.point[axis]);
      }
    }
  }
}

TEST(PlaceOnLine, WithAnotherLengthOrFromTheOtherEnd_CountsOtherwise) {
  RandomNumbers random(122);
  for (int i = 0; i < test::effort(2'000); ++i) {
    const auto [through, direction, point] = anyGiven(random);
    const auto place = placeOnLine(point, through, direction);
    if (place.which == LinePlace::Off || place.which == LinePlace::ZeroDirection)
      continue;
    const Rational k = random.nonZeroRational(3);
    EXPECT_EQ(placeOnLine(point, through, Exact(direction * k)).t, Rational(place.t / k)); // law (3)
    const auto back = placeOnLine(point, Exact(through + direction), Exact(-direction));   // law (4)
    EXPECT_EQ(back.t, Rational(1 - place.t));
    EXPECT_EQ(back.which, place.which == LinePlace::Before   ? LinePlace::Beyond
                          : place.which == LinePlace::Beyond ? LinePlace::Before
                                                             : LinePlace::Segment);
  }
}

} // namespace
} // namespace halfspace
