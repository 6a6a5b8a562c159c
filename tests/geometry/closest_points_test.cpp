#include "geometry/closest_points.h"
#include "geometry/relate_lines.h"

#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

namespace halfspace {
namespace {

TEST(ClosestPoints, OfARoadAndABridge_LieStraightAboveEachOther) {
  const auto closest =
      closestPoints(ExactVec3(5, 2, 0), ExactVec3(1, 0, 0), ExactVec3(7, 1, 3), ExactVec3(0, 2, 0));
  EXPECT_EQ(closest.which, ClosestPointsCase::Skew);
  EXPECT_EQ(closest.s, 2);
  EXPECT_EQ(closest.t, Rational(1, 2));
  EXPECT_EQ(closest.first, ExactVec3(7, 2, 0));
  EXPECT_EQ(closest.second, ExactVec3(7, 2, 3));
  EXPECT_EQ(closest.distance, Surd(3));
}

TEST(ClosestPoints, OfLinesThatMeet_AreBothTheCommonPoint) {
  const auto closest =
      closestPoints(ExactVec3(1, 1, 1), ExactVec3(1, 2, 3), ExactVec3(3, 5, 0), ExactVec3(0, 0, -1));
  EXPECT_EQ(closest.which, ClosestPointsCase::Meet);
  EXPECT_EQ(closest.first, ExactVec3(3, 5, 7));
  EXPECT_EQ(closest.second, ExactVec3(3, 5, 7));
  EXPECT_EQ(closest.distance, Surd(0));
}

TEST(ClosestPoints, OfParallelLines_AreNoSinglePairButHaveADistance) {
  const ExactVec3 v(2, 0, 0);
  const auto beside = closestPoints(ExactVec3(0), v, ExactVec3(5, 3, 4), ExactVec3(-1, 0, 0));
  EXPECT_EQ(beside.which, ClosestPointsCase::Parallel);
  EXPECT_EQ(beside.distance, Surd(5));
  const auto same = closestPoints(ExactVec3(0), v, ExactVec3(5, 0, 0), ExactVec3(3, 0, 0));
  EXPECT_EQ(same.which, ClosestPointsCase::Coincident);
  EXPECT_EQ(same.distance, Surd(0));
}

TEST(ClosestPoints, WithoutADirection_AreToldAsNone) {
  const ExactVec3 v(1, 2, 3);
  EXPECT_EQ(closestPoints(ExactVec3(1), v, ExactVec3(2), ExactVec3(0)).which,
            ClosestPointsCase::ZeroDirection);
  EXPECT_EQ(closestPoints(ExactVec3(1), ExactVec3(0), ExactVec3(2), v).which,
            ClosestPointsCase::ZeroDirection);
}

/// Two lines with small numbers, often parallel, and often with a common point.
struct TwoLines {
  explicit TwoLines(RandomNumbers &random)
      : A(random.wholeVector(6)), v(random.nonZeroWholeVector(4)), B(random.wholeVector(6)),
        w(random.nonZeroWholeVector(4)) {
    const int choice = random.integer(0, 6);
    if (choice == 0 || choice == 1)
      w = v * random.nonZeroRational(3);
    if (choice == 1 || choice == 2)
      B = A + v * random.rational(3) + w * random.rational(3);
  }

  [[nodiscard]] ClosestPoints<Rational> closest() const { return closestPoints(A, v, B, w); }
  [[nodiscard]] bool hasPair() const { return !isZero(cross(v, w)); }

  ExactVec3 A, v, B, w;
};

TEST(ClosestPoints, OfAnyLines_AreWherePlueckerCoordinatesSay) {
  RandomNumbers random(111);
  for (int i = 0; i < test::effort(10'000); ++i) {
    const TwoLines at(random);
    const auto closest = at.closest();
    const Line<Rational> g = lineAlong(at.A, at.v);
    const Line<Rational> h = lineAlong(at.B, at.w);
    const auto related = relateLines(g, h);
    EXPECT_EQ(closest.distance, related.distance);
    EXPECT_EQ(closest.which == ClosestPointsCase::Skew, related.which == LineLineCase::Skew);
    EXPECT_EQ(closest.which == ClosestPointsCase::Meet, related.which == LineLineCase::Intersecting);
    EXPECT_EQ(closest.which == ClosestPointsCase::Parallel, related.which == LineLineCase::Parallel);
    EXPECT_EQ(closest.volume, Rational(-related.product));
    if (!at.hasPair())
      continue;
    const auto nearest = nearestPoints(g, h);
    EXPECT_EQ(closest.first, nearest.first);
    EXPECT_EQ(closest.second, nearest.second);
  }
}

TEST(ClosestPoints, OfLinesThatAreNotParallel_AreNearerThanAnyOthers) { // laws (1) to (3)
  RandomNumbers random(112);
  for (int i = 0; i < test::effort(10'000); ++i) {
    const TwoLines at(random);
    if (!at.hasPair())
      continue;
    const auto closest = at.closest();
    const ExactVec3 way = closest.second - closest.first;
    EXPECT_EQ(dot(way, at.v), 0);
    EXPECT_EQ(dot(way, at.w), 0);
    const ExactVec3 X = at.A + at.v * random.rational(5);
    const ExactVec3 Y = at.B + at.w * random.rational(5);
    const ExactVec3 other = Y - X;
    const ExactVec3 aside = (X - closest.first) - (Y - closest.second);
    EXPECT_EQ(dot(other, other), Rational(dot(way, way) + dot(aside, aside)));
    EXPECT_EQ(closest.distance, Surd::root(dot(way, way)));
    EXPECT_EQ(closest.which == ClosestPointsCase::Meet, isZero(way));
  }
}

TEST(ClosestPoints, OfTheSameLinesWrittenOtherwise_AreTheSame) { // laws (4) and (5)
  RandomNumbers random(113);
  for (int i = 0; i < test::effort(2000); ++i) {
    const TwoLines at(random);
    const auto closest = at.closest();
    const auto written = closestPoints(
        ExactVec3(at.A + at.v * random.rational(3)), ExactVec3(at.v * random.nonZeroRational(3)),
        ExactVec3(at.B + at.w * random.rational(3)), ExactVec3(at.w * random.nonZeroRational(3)));
    EXPECT_EQ(written.which, closest.which);
    EXPECT_EQ(written.first, closest.first);
    EXPECT_EQ(written.second, closest.second);
    EXPECT_EQ(written.distance, closest.distance);
    const auto exchanged = closestPoints(at.B, at.w, at.A, at.v);
    EXPECT_EQ(exchanged.which, closest.which);
    EXPECT_EQ(exchanged.s, closest.t);
    EXPECT_EQ(exchanged.t, closest.s);
    EXPECT_EQ(exchanged.first, closest.second);
    EXPECT_EQ(exchanged.distance, closest.distance);
  }
}

} // namespace
} // namespace halfspace
