#include "geometry/polygon_area.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace halfspace {
namespace {

using Corners = Polygon<Rational>;

/// From numbers in the plane z = 1.
Corners flat(const std::vector<std::pair<int, int>> &places) {
  Corners corners;
  for (const auto &[x, y] : places)
    corners.emplace_back(x, y, 1);
  return corners;
}

Corners anyPolygon(RandomNumbers &random, int limit) {
  Corners corners;
  const ExactVec3 across = random.nonZeroWholeVector(1);
  const ExactVec3 up = random.nonZeroWholeVector(1);
  for (int count = random.integer(3, 6); count > 0; --count)
    corners.push_back(across * Rational(random.integer(0, limit)) + up * Rational(random.integer(0, limit)));
  if (random.integer(0, 9) == 0)
    corners.back() += random.wholeVector(1);
  return corners;
}

/// Twice the area by cutting off ears, which only a boundary that does not meet itself always has; nothing
/// where none is left before the end. Of corners in the plane z = 1 counterclockwise.
std::optional<Rational> byEars(Corners corners) {
  Rational area = 0;
  const auto turn = [](const ExactVec3 &a, const ExactVec3 &b, const ExactVec3 &c) -> Rational {
    return cross(ExactVec3(b - a), ExactVec3(c - a)).z;
  };
  while (corners.size() > 3) {
    const std::size_t count = corners.size();
    bool found = false;
    for (std::size_t i = 0; i < count && !found; ++i) {
      const ExactVec3 a = corners[i];
      const ExactVec3 b = corners[(i + 1) % count];
      const ExactVec3 c = corners[(i + 2) % count];
      const bool isEar =
          turn(a, b, c) >= 0 && std::none_of(corners.begin(), corners.end(), [&](const ExactVec3 &p) {
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                   turn(c, a, p) >= 0;
          });
      if (!isEar)
        continue;
      area += turn(a, b, c);
      corners.erase(corners.begin() + static_cast<std::ptrdiff_t>((i + 1) % count));
      found = true;
    }
    if (!found)
      return {};
  }
  return area + turn(corners[0], corners[1], corners[2]);
}

TEST(PolygonArea, OfEachCase_IsWhatItIsKnownToBe) {
  const auto square = polygonArea(flat({{0, 0}, {3, 0}, {3, 3}, {0, 3}}));
  EXPECT_EQ(square.which, PolygonAreaCase::Simple);
  EXPECT_EQ(square.area, Surd(9));
  EXPECT_EQ(square.sum, ExactVec3(0, 0, 18));
  const auto bent = polygonArea(flat({{0, 0}, {4, 0}, {1, 1}, {0, 4}}));
  EXPECT_EQ(bent.which, PolygonAreaCase::Simple);
  EXPECT_EQ(bent.area, Surd(4));
  const auto bow = polygonArea(flat({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
  EXPECT_EQ(bow.which, PolygonAreaCase::SelfMeeting);
  EXPECT_EQ(bow.area, Surd(0));
  EXPECT_EQ(polygonArea(flat({{0, 0}, {1, 2}, {2, 4}, {3, 6}})).which, PolygonAreaCase::OnOneLine);
  Corners skew = flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  skew[2].z = 2;
  EXPECT_EQ(polygonArea(skew).which, PolygonAreaCase::NotPlanar);
}

TEST(PolygonArea, OfABoundaryThatMeetsItself_IsSaid) {
  const auto caseOf = [](const std::vector<std::pair<int, int>> &places) {
    return polygonArea(flat(places)).which;
  };
  EXPECT_EQ(caseOf({{0, 0}, {4, 0}, {2, 0}, {2, 3}}), PolygonAreaCase::SelfMeeting) << "back along a side";
  EXPECT_EQ(caseOf({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), PolygonAreaCase::SelfMeeting)
      << "a corner on a side";
  EXPECT_EQ(caseOf({{0, 0}, {2, 1}, {4, 0}, {4, 2}, {2, 1}, {0, 2}}), PolygonAreaCase::SelfMeeting)
      << "a corner on a corner";
  EXPECT_EQ(caseOf({{0, 0}, {2, 0}, {4, 0}, {4, 4}}), PolygonAreaCase::Simple) << "a straight corner";
  EXPECT_EQ(caseOf({{0, 0}, {4, 0}, {4, 0}, {4, 4}, {0, 0}}), PolygonAreaCase::Simple)
      << "a corner twice in a row";
}

TEST(PolygonArea, FromAnotherCornerBackwardsMovedOrLarger_IsTheSameTurnedOrLarger) { // laws (1), (2) and (3)
  RandomNumbers random(421);
  std::map<PolygonAreaCase, int> cases;
  for (int i = 0; i < test::effort(4000); ++i) {
    Corners corners = anyPolygon(random, 3);
    const auto area = polygonArea(corners);
    ++cases[area.which];
    const ExactVec3 way = random.vector(3);
    const Rational k = random.nonZeroRational(3);
    const bool isTurned = random.integer(0, 1) == 0;
    std::rotate(corners.begin(), corners.begin() + random.integer(0, 2), corners.end());
    if (isTurned)
      std::reverse(corners.begin(), corners.end());
    for (ExactVec3 &corner : corners)
      corner = (corner + way) * k;
    const auto other = polygonArea(corners);
    EXPECT_EQ(other.which, area.which);
    EXPECT_EQ(other.sum, area.sum * Rational(isTurned ? -k * k : k * k));
    EXPECT_EQ(other.area, area.area * Rational(k * k));
    if (area.which != PolygonAreaCase::NotPlanar) {
      for (const ExactVec3 &corner : corners)
        EXPECT_EQ(dot(area.sum, ExactVec3(corner - corners[0])), 0);
    }
    if (area.which == PolygonAreaCase::OnOneLine) {
      EXPECT_EQ(area.sum, ExactVec3(0));
    }
  }
  EXPECT_EQ(cases.size(), 4U) << "a case did not come up";
}

TEST(PolygonArea, OfSimplePolygons_IsThatOfTheEarsCutOff) { // law (4)
  RandomNumbers random(422);
  int simple = 0;
  for (int i = 0; i < test::effort(4000); ++i) {
    Corners corners;
    for (int count = random.integer(3, 6); count > 0; --count)
      corners.emplace_back(random.integer(0, 4), random.integer(0, 4), 1);
    auto area = polygonArea(corners);
    if (area.which != PolygonAreaCase::Simple)
      continue;
    ++simple;
    if (area.sum.z < 0)
      std::reverse(corners.begin(), corners.end());
    EXPECT_EQ(byEars(corners), abs(area.sum.z));
    EXPECT_EQ(area.area, Surd(Rational(abs(area.sum.z) / 2)));
  }
  EXPECT_GT(simple, test::effort(4000) / 10);
}

TEST(PolygonArea, OfStrictlyConvexPolygons_IsSimple) {
  RandomNumbers random(423);
  int convex = 0;
  for (int i = 0; i < test::effort(4000); ++i) {
    const Corners corners = anyPolygon(random, 3);
    if (shapeOf(corners) != PolygonShape::Convex)
      continue;
    ++convex;
    EXPECT_EQ(polygonArea(corners).which, PolygonAreaCase::Simple);
  }
  EXPECT_GE(convex, test::atLeast(200));
}

} // namespace
} // namespace halfspace
