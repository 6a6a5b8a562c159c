#include "geometry/circumsphere.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace halfspace {
namespace {

using Four = std::array<ExactVec3, 4>;

Rational squaredDistance(const ExactVec3 &a, const ExactVec3 &b) {
  const ExactVec3 way = a - b;
  return dot(way, way);
}

Four anyFour(RandomNumbers &random, int limit) {
  return {random.wholeVector(limit), random.wholeVector(limit), random.wholeVector(limit),
          random.wholeVector(limit)};
}

/// By the definition: in the plane of the points, the bisectors of all pairs. Points of a plane have a common
/// sphere where three on a line are not three places, and all keep to the circle of three that are not.
bool haveSphereByCircle(const Four &points) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i + 1; j < 4; ++j)
      for (std::size_t k = j + 1; k < 4; ++k) {
        const ExactVec3 u = points[j] - points[i];
        const ExactVec3 v = points[k] - points[i];
        const ExactVec3 n = cross(u, v);
        if (isZero(n)) {
          if (!isZero(u) && !isZero(v) && u != v)
            return false;
          continue;
        }
        // The centre of the circle of three corners, from the well-known formula.
        const ExactVec3 way =
            cross(ExactVec3(v * dot(u, u) - u * dot(v, v)), n) * Rational(Rational(-1, 2) / dot(n, n));
        const ExactVec3 center = points[i] - way;
        const std::size_t other = 6 - i - j - k;
        if (squaredDistance(center, points[other]) != squaredDistance(center, points[i]))
          return false;
      }
  return true;
}

TEST(Circumsphere, CornerOfABox_HasTheBoxesCentre) {
  const auto sphere = circumsphereOf<Rational>(
      {ExactVec3(1, 1, 1), ExactVec3(3, 1, 1), ExactVec3(1, 5, 1), ExactVec3(1, 1, 5)});
  EXPECT_EQ(sphere.which, CircumsphereCase::Sphere);
  EXPECT_EQ(sphere.center, ExactVec3(2, 3, 3));
  EXPECT_EQ(sphere.radius, Surd(3));
  EXPECT_EQ(sphere.determinant, 32);
}

TEST(Circumsphere, AnyFourPoints_AreEquallyFarFromTheCentre) { // laws (1) and (2)
  RandomNumbers random(401);
  std::map<CircumsphereCase, int> cases;
  for (int i = 0; i < test::effort(4000); ++i) {
    const Four points = anyFour(random, 1 + i % 3);
    const auto sphere = circumsphereOf(points);
    ++cases[sphere.which];
    const ExactVec3 u = points[1] - points[0];
    const ExactVec3 v = points[2] - points[0];
    const ExactVec3 w = points[3] - points[0];
    EXPECT_EQ(sphere.determinant == 0, sphere.which != CircumsphereCase::Sphere);
    EXPECT_EQ(sphere.determinant, dot(w, cross(u, v)));
    if (sphere.which != CircumsphereCase::Sphere) {
      EXPECT_EQ(sphere.which == CircumsphereCase::ManySpheres, haveSphereByCircle(points));
      continue;
    }
    for (const ExactVec3 &point : points)
      EXPECT_EQ(squaredDistance(point, sphere.center), sphere.radiusSquared);
    EXPECT_EQ(sphere.radius.squared(), Surd(sphere.radiusSquared));
    EXPECT_GE(sphere.radius.sign(), 0);
  }
  EXPECT_EQ(cases.size(), 3U) << "a case did not come up";
}

TEST(Circumsphere, OfPointsInAnotherOrderMovedOrLarger_IsTheSameMovedOrLarger) { // laws (3) and (4)
  RandomNumbers random(402);
  for (int i = 0; i < test::effort(1500); ++i) {
    Four points = anyFour(random, 2);
    const auto sphere = circumsphereOf(points);
    std::rotate(points.begin(), points.begin() + random.integer(1, 3), points.end());
    std::swap(points[0], points[static_cast<std::size_t>(random.integer(0, 3))]);
    const ExactVec3 way = random.vector(3);
    const Rational k = random.nonZeroRational(3);
    for (ExactVec3 &point : points)
      point = (point + way) * k;
    const auto other = circumsphereOf(points);
    EXPECT_EQ(other.which, sphere.which);
    if (sphere.which != CircumsphereCase::Sphere)
      continue;
    EXPECT_EQ(other.center, (sphere.center + way) * k);
    EXPECT_EQ(other.radius, sphere.radius * abs(k));
  }
}

TEST(Circumsphere, PointMovedOutOfACircleByAHair_HasASphereOrNone) {
  const auto with = [](const ExactVec3 &last) {
    return circumsphereOf<Rational>({ExactVec3(1, 0, 0), ExactVec3(0, 1, 0), ExactVec3(-1, 0, 0), last})
        .which;
  };
  EXPECT_EQ(with(ExactVec3(0, -1, 0)), CircumsphereCase::ManySpheres);
  for (int k = 1; k <= 40; ++k) {
    const Rational hair = powerOfTen(-k);
    EXPECT_EQ(with(ExactVec3(0, Rational(-1 - hair), 0)), CircumsphereCase::NoSphere);
    EXPECT_EQ(with(ExactVec3(0, -1, hair)), CircumsphereCase::Sphere);
  }
}

} // namespace
} // namespace halfspace
