#include "geometry/clip.h"
#include "geometry/polygon.h"
#include "tests/effort.h"
#include "tests/geometry/random_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace halfspace {
namespace {

using Corners = std::vector<ExactVec3>;

Corners clipped(const Corners &corners, const Plane<Rational> &plane) {
  return clipPolygon(std::span<const ExactVec3>(corners), plane);
}

Plane<Rational> times(const Plane<Rational> &plane, const Rational &k) {
  return {plane.normal * k, Rational(plane.offset * k)};
}

/// y + 2z = 12, kept above.
const Plane<Rational> slope{{0, 1, 2}, -12};

TEST(ClipPolygon, OneCornerOfThreeCutOff_LeavesFourInTheirOrder) {
  EXPECT_EQ(clipped({{2, 4, 7}, {5, 7, 1}, {1, 11, 5}}, slope),
            (Corners{{4, 6, 3}, {4, 8, 2}, {1, 11, 5}, {2, 4, 7}}));
}

TEST(ClipPolygon, TwoCornersOfThreeCutOff_LeaveATriangle) {
  EXPECT_EQ(clipped({{2, 4, 7}, {5, 7, 1}, {2, 1, 4}}, slope), (Corners{{4, 6, 3}, {2, 2, 5}, {2, 4, 7}}));
}

TEST(ClipPolygon, WhollyOnOneSide_IsKeptOrNothingIsLeft) {
  EXPECT_EQ(clipped({{0, 0, 7}, {5, 0, 7}, {0, 5, 7}}, slope), (Corners{{5, 0, 7}, {0, 5, 7}, {0, 0, 7}}));
  EXPECT_TRUE(clipped({{0, 0, 1}, {5, 0, 1}, {0, 5, 1}}, slope).empty());
}

TEST(ClipPolygon, WithCornersInThePlane_NamesThemOnce) {
  const ExactVec3 inPlane{0, 0, 6};
  const ExactVec3 alsoInPlane{3, 0, 6};
  const ExactVec3 above{5, 0, 9};
  const ExactVec3 below{5, 0, 3};
  EXPECT_EQ(clipped({inPlane, above, below}, slope), (Corners{above, {5, 0, 6}, inPlane}));
  EXPECT_EQ(clipped({inPlane, alsoInPlane, above}, slope), (Corners{alsoInPlane, above, inPlane}));
  EXPECT_EQ(clipped({inPlane, alsoInPlane, below}, slope), (Corners{alsoInPlane, inPlane}));
  EXPECT_EQ(clipped({inPlane, below, {0, 0, 1}}, slope), Corners{inPlane});
  EXPECT_EQ(clipped({inPlane, alsoInPlane, {0, 2, 5}}, slope), (Corners{alsoInPlane, {0, 2, 5}, inPlane}));
}

struct EdgeAtPlane {
  explicit EdgeAtPlane(RandomNumbers &random)
      : plane{random.nonZeroWholeVector(3), Rational(random.integer(-6, 6))}, from(random.wholeVector(5)),
        to(random.wholeVector(5)) {}

  [[nodiscard]] EdgeClip<Rational> clip() const { return at(1); }
  [[nodiscard]] EdgeClip<Rational> at(const Rational &k) const {
    return clipEdge(from, Rational(k * evaluate(plane, from)), to, Rational(k * evaluate(plane, to)));
  }
  [[nodiscard]] EdgeClip<Rational> back() const {
    return clipEdge(to, evaluate(plane, to), from, evaluate(plane, from));
  }

  Plane<Rational> plane;
  ExactVec3 from;
  ExactVec3 to;
};

TEST(ClipEdge, IsCutBetweenEndsOfBothSigns_InThePlane) { // laws (1) and (4)
  RandomNumbers random(101);
  for (int i = 0; i < test::effort(2000); ++i) {
    const EdgeAtPlane at(random);
    const auto clip = at.clip();
    const int atFrom = evaluate(at.plane, at.from).sign();
    const int atTo = evaluate(at.plane, at.to).sign();
    EXPECT_EQ(clip.isCut, atFrom * atTo < 0);
    EXPECT_EQ(clip.which, atFrom >= 0 ? (atTo >= 0 ? EdgeCase::Kept : EdgeCase::Leaves)
                                      : (atTo >= 0 ? EdgeCase::Enters : EdgeCase::Outside));
    if (!clip.isCut)
      continue;
    EXPECT_GT(clip.t, 0);
    EXPECT_LT(clip.t, 1);
    EXPECT_EQ(clip.point, ExactVec3(at.from + (at.to - at.from) * clip.t));
    EXPECT_EQ(evaluate(at.plane, clip.point), 0);
  }
}

TEST(ClipEdge, OfALongerNormalOrTheOtherWayRound_IsCutAtTheSamePoint) { // laws (2) and (3)
  RandomNumbers random(102);
  for (int i = 0; i < test::effort(1000); ++i) {
    const EdgeAtPlane at(random);
    const auto clip = at.clip();
    const auto scaled = at.at(abs(random.nonZeroRational()));
    EXPECT_EQ(scaled.which, clip.which);
    EXPECT_EQ(scaled.t, clip.t);
    EXPECT_EQ(scaled.point, clip.point);
    const auto back = at.back();
    EXPECT_EQ(back.isCut, clip.isCut);
    EXPECT_EQ(back.point, clip.point);
    EXPECT_EQ(back.which == EdgeCase::Leaves, clip.which == EdgeCase::Enters);
    if (clip.isCut) {
      EXPECT_EQ(back.t, Rational(1 - clip.t));
    }
  }
}

TEST(ClipEdge, OverDoubles_NeighboursShareTheCutToTheLastBit) { // law (3)
  RandomNumbers random(103);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Vec3<double> from = toDouble(random.vector());
    const Vec3<double> to = toDouble(random.vector());
    const Plane<double> plane{toDouble(random.vector()), toDouble(random.rational())};
    const double atFrom = evaluate(plane, from);
    const double atTo = evaluate(plane, to);
    EXPECT_EQ(clipEdge(from, atFrom, to, atTo).point, clipEdge(to, atTo, from, atFrom).point);
  }
}

/// A convex polygon and a plane with small numbers, often through some of its corners.
struct PolygonAtPlane {
  explicit PolygonAtPlane(RandomNumbers &random) : corners(randomPolygon(random)), plane(planeAt(random)) {}

  [[nodiscard]] Corners left() const { return clipped(corners, plane); }

  Corners corners;
  Plane<Rational> plane;

private:
  [[nodiscard]] Plane<Rational> planeAt(RandomNumbers &random) const {
    ExactVec3 normal = random.nonZeroWholeVector(4);
    const ExactVec3 &through = corners[static_cast<std::size_t>(random.integer(0, 2))];
    if (random.integer(0, 4) == 0) // along an edge, or in the polygon's plane
      if (const ExactVec3 along = cross(ExactVec3(corners[1] - corners[0]), normal); !isZero(along))
        normal = along;
    return random.integer(0, 2) == 0 ? Plane<Rational>{normal, Rational(random.integer(-20, 20))}
                                     : planeThrough(through, normal);
  }
};

/// Twice the area as a vector: their sum over the parts of a polygon is that of the whole.
ExactVec3 areaVector(const Corners &corners) {
  ExactVec3 sum(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += cross(ExactVec3(corners[i] - corners[0]), ExactVec3(corners[i + 1] - corners[0]));
  return sum;
}

/// Whether a point of a convex polygon's plane is in it, or on its border.
bool isIn(const Corners &corners, const ExactVec3 &point) {
  const ExactVec3 normal = areaVector(corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactVec3 edge = corners[(i + 1) % corners.size()] - corners[i];
    if (dot(cross(edge, ExactVec3(point - corners[i])), normal) < 0)
      return false;
  }
  return !isZero(normal);
}

/// Of the corners with random weights.
ExactVec3 pointIn(const Corners &corners, RandomNumbers &random) {
  ExactVec3 sum(0);
  Rational weights = 0;
  for (const ExactVec3 &corner : corners) {
    const Rational weight(random.integer(1, 9));
    sum += corner * weight;
    weights += weight;
  }
  return sum * Rational(1 / weights);
}

TEST(ClipPolygon, KeepsThePointsOfThePositiveSide) { // laws (1) to (3)
  RandomNumbers random(104);
  for (int i = 0; i < test::effort(2000); ++i) {
    const PolygonAtPlane at(random);
    const Corners left = at.left();
    EXPECT_LE(left.size(), at.corners.size() + 1);
    for (const ExactVec3 &corner : left)
      EXPECT_GE(evaluate(at.plane, corner), 0);
    const bool hasArea = left.size() > 2;
    if (hasArea) {
      EXPECT_EQ(shapeOf(left), PolygonShape::Convex);
      EXPECT_GT(dot(areaVector(left), areaVector(at.corners)), 0);
    }
    const ExactVec3 point = pointIn(at.corners, random);
    EXPECT_EQ(hasArea && isIn(left, point), evaluate(at.plane, point) >= 0);
  }
}

TEST(ClipPolygon, ByALongerNormalOrOnceMore_LeavesTheSame) { // laws (4) and (5)
  RandomNumbers random(105);
  for (int i = 0; i < test::effort(500); ++i) {
    const PolygonAtPlane at(random);
    const Corners left = at.left();
    EXPECT_EQ(clipped(at.corners, times(at.plane, abs(random.nonZeroRational()))), left);
    Corners again = clipped(left, at.plane);
    if (!again.empty()) // each time round the list begins one corner later
      std::rotate(again.begin(), again.end() - 1, again.end());
    if (left.size() > 2) {
      EXPECT_EQ(again, left);
    }
  }
}

TEST(ClipPolygon, ByBothSides_FallsIntoTwo) { // law (6)
  RandomNumbers random(106);
  for (int i = 0; i < test::effort(500); ++i) {
    const PolygonAtPlane at(random);
    const ExactVec3 whole = areaVector(at.corners);
    const ExactVec3 parts = areaVector(at.left()) + areaVector(clipped(at.corners, times(at.plane, -1)));
    const bool isInPlane = std::all_of(at.corners.begin(), at.corners.end(), [&](const ExactVec3 &corner) {
      return evaluate(at.plane, corner) == 0;
    });
    EXPECT_EQ(parts, isInPlane ? ExactVec3(whole * Rational(2)) : whole);
  }
}

TEST(ClipPolygon, ByTwoPlanes_LeavesTheSameInEitherOrder) { // law (7)
  RandomNumbers random(107);
  for (int i = 0; i < test::effort(500); ++i) {
    const PolygonAtPlane at(random);
    const Plane<Rational> second = PolygonAtPlane(random).plane;
    const Corners one = clipped(at.left(), second);
    const Corners other = clipped(clipped(at.corners, second), at.plane);
    EXPECT_EQ(areaVector(one), areaVector(other));
    const ExactVec3 point = pointIn(at.corners, random);
    EXPECT_EQ(one.size() > 2 && isIn(one, point) && !isZero(areaVector(one)),
              evaluate(at.plane, point) >= 0 && evaluate(second, point) >= 0 && !isZero(areaVector(one)));
  }
}

} // namespace
} // namespace halfspace
