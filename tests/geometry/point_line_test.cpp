#include "geometry/point_line.h"

#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

using Exact = Vec3<Rational>;

TEST(PointLine, BesideAnAxis_IsAsFarAsTheOtherCoordinatesSay) {
  const auto measured = measurePointLine(Exact(5, 3, 4), Exact(1, 0, 0), Exact(2, 0, 0));
  EXPECT_EQ(measured.which, PointLineCase::Off);
  EXPECT_EQ(measured.t, 2);
  EXPECT_EQ(measured.foot, Exact(5, 0, 0));
  EXPECT_EQ(measured.distance, Surd(5));
}

TEST(PointLine, OnTheLine_IsItsOwnFoot) {
  const auto measured = measurePointLine(Exact(7, 7, 7), Exact(1, 1, 1), Exact(-3, -3, -3));
  EXPECT_EQ(measured.which, PointLineCase::On);
  EXPECT_EQ(measured.t, -2);
  EXPECT_EQ(measured.distance, Surd(0));
}

TEST(PointLine, ALineWithoutDirection_IsToldAsOne) {
  EXPECT_EQ(measurePointLine(Exact(1, 2, 3), Exact(1, 2, 3), Exact(0)).which, PointLineCase::ZeroDirection);
}

TEST(PointLine, OfAnyNumbers_HasAFootStraightBelowAndThePlueckerDistance) {
  std::mt19937_64 engine(9);
  const auto number = [&] {
    return Rational(static_cast<int>(engine() % 41) - 20, 1 + static_cast<int>(engine() % 5));
  };
  const auto vector = [&] {
    const Rational x = number();
    const Rational y = number();
    return Exact(x, y, number());
  };
  for (int i = 0; i < test::effort(500); ++i) {
    const Exact point = vector();
    const Exact through = vector();
    const Exact direction = vector();
    if (isZero(direction))
      continue;
    const auto measured = measurePointLine(point, through, direction);
    EXPECT_EQ(measured.foot, Exact(through + direction * measured.t)); // law (1)
    EXPECT_EQ(dot(Exact(point - measured.foot), direction), 0);        // law (2)
    // |w×v|/|v| by another way: law (3).
    const Exact moment = cross(Exact(point - through), direction);
    EXPECT_EQ(measured.distance, Surd::root(Rational(dot(moment, moment) / dot(direction, direction))));
    EXPECT_EQ(measured.which == PointLineCase::On, measured.distance == Surd(0));

    const Exact other = through + direction * number();
    const Exact way = point - measured.foot;
    const Exact longer = point - other;
    const Exact along = measured.foot - other;
    EXPECT_EQ(dot(longer, longer), dot(way, way) + dot(along, along)); // law (4)
    const Rational k = i % 2 == 0 ? 3 : Rational(-1, 2);
    const auto again = measurePointLine(point, other, Exact(direction * k));
    EXPECT_EQ(again.which, measured.which); // law (5)
    EXPECT_EQ(again.foot, measured.foot);
    EXPECT_EQ(again.distance, measured.distance);
  }
}

} // namespace
} // namespace halfspace
