// Three planes, in each way that they can stand to each other.
#include "geometry/intersect_line_plane.h"
#include "geometry/intersect_three_planes.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

using ExactPlane = Plane<Rational>;

TEST(IntersectThreePlanes, ParallelToTheAxes_MeetInThePointOfTheirOffsets) {
  const auto meet =
      intersectPlanes(ExactPlane{{1, 0, 0}, -2}, ExactPlane{{0, 2, 0}, -6}, ExactPlane{{0, 0, 3}, 12});
  EXPECT_EQ(meet.which, ThreePlanesCase::Point);
  EXPECT_EQ(meet.weight, 6);
  EXPECT_EQ(meet.weighted, ExactVec3(12, 18, -24));
  EXPECT_EQ(meet.point, ExactVec3(2, 3, -4));
  EXPECT_EQ(meet.directions[2], ExactVec3(0, 0, 2));
}

TEST(IntersectThreePlanes, WithoutASinglePoint_AreToldApart) {
  const auto caseOf = [](const ExactPlane &a, const ExactPlane &b, const ExactPlane &c) {
    return intersectPlanes(a, b, c).which;
  };
  const ExactPlane x0{{1, 0, 0}, 0};
  const ExactPlane x1{{2, 0, 0}, -2};
  const ExactPlane y0{{0, 1, 0}, 0};
  const ExactPlane sloping{{1, 1, 0}, 0};
  const ExactPlane aside{{1, 1, 0}, -1};
  const ExactPlane minusX0{{-3, 0, 0}, 0};
  const ExactPlane none{{0, 0, 0}, 1};
  EXPECT_EQ(caseOf(x0, y0, sloping), ThreePlanesCase::Line);
  EXPECT_EQ(caseOf(x0, y0, minusX0), ThreePlanesCase::Line) << "two of them are the same";
  EXPECT_EQ(caseOf(x0, y0, aside), ThreePlanesCase::Prism);
  EXPECT_EQ(caseOf(x0, y0, x1), ThreePlanesCase::Parallel);
  EXPECT_EQ(caseOf(x0, minusX0, x1), ThreePlanesCase::Parallel) << "two of them are the same";
  EXPECT_EQ(caseOf(x0, x1, {{1, 0, 0}, -2}), ThreePlanesCase::Parallel);
  EXPECT_EQ(caseOf(x0, minusX0, x0), ThreePlanesCase::Coincident);
  EXPECT_EQ(caseOf(x0, y0, none), ThreePlanesCase::ZeroNormal);
  EXPECT_EQ(caseOf(none, none, none), ThreePlanesCase::ZeroNormal);
}

/// Laws that the numbers of small integers come to in every case.
TEST(IntersectThreePlanes, AnyThree_FollowTheLaws) {
  RandomNumbers random(311);
  std::map<ThreePlanesCase, int> cases;
  const int count = test::effort(10'000);
  for (int i = 0; i < count; ++i) {
    const auto any = [&] { return ExactPlane{random.wholeVector(1), random.integer(-1, 1)}; };
    const ExactPlane a = any();
    const ExactPlane b = any();
    const ExactPlane c = any();
    const auto meet = intersectPlanes(a, b, c);
    ++cases[meet.which];
    if (meet.which == ThreePlanesCase::Point) {
      EXPECT_EQ(evaluate(a, meet.point), 0); // law (1)
      EXPECT_EQ(evaluate(b, meet.point), 0);
      EXPECT_EQ(evaluate(c, meet.point), 0);
    }
    if (meet.which != ThreePlanesCase::ZeroNormal) {
      EXPECT_EQ(meet.weight == 0, meet.which != ThreePlanesCase::Point); // law (2)
    }
    for (const auto &[swapped, sign] : {std::pair(intersectPlanes(b, a, c), -1), // law (3)
                                        std::pair(intersectPlanes(b, c, a), 1)}) {
      EXPECT_EQ(swapped.which, meet.which);
      EXPECT_EQ(swapped.weight, meet.weight * sign);
      EXPECT_EQ(swapped.weighted, ExactVec3(meet.weighted * Rational(sign)));
      EXPECT_EQ(swapped.point, meet.point);
    }
    const Rational k = random.nonZeroRational();
    const auto scaled = intersectPlanes({a.normal * k, Rational(a.offset * k)}, b, c); // law (4)
    EXPECT_EQ(scaled.which, meet.which);
    EXPECT_EQ(scaled.weighted, ExactVec3(meet.weighted * k));
    EXPECT_EQ(scaled.point, meet.point);
    const bool areAlong = isZero(cross(a.normal, b.normal)) && isZero(cross(b.normal, c.normal)) &&
                          isZero(cross(c.normal, a.normal));
    if (meet.weight == 0 && !areAlong && meet.which != ThreePlanesCase::ZeroNormal) { // law (5)
      for (const ExactPlane &plane : {a, b, c})
        EXPECT_EQ(dot(plane.normal, meet.weighted), 0);
      EXPECT_EQ(isZero(meet.weighted), meet.which == ThreePlanesCase::Line);
    }
  }
  if (!test::isWatched) {
    EXPECT_EQ(cases.size(), 6U) << "a case did not come up";
  }
}

TEST(IntersectThreePlanes, ThePoint_IsThatOfTheLineOfTwoWithTheThird) {
  RandomNumbers random(312);
  for (int i = 0; i < test::effort(1000); ++i) {
    const ExactPlane a{random.nonZeroVector(), random.rational()};
    const ExactPlane b{random.nonZeroVector(), random.rational()};
    const ExactPlane c{random.nonZeroVector(), random.rational()};
    const auto pair = intersectPlanes(a, b);
    if (pair.which != PlanePlaneCase::Line)
      continue;
    const auto met = intersectLinePlane(pair.line, c);
    const auto meet = intersectPlanes(a, b, c);
    EXPECT_EQ(meet.weight, met.weight);
    EXPECT_EQ(meet.weighted, met.weighted);
    EXPECT_EQ(meet.point, met.point);
  }
}

} // namespace
} // namespace halfspace
