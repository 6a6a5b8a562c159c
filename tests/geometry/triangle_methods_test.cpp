// The three methods for a ray and a triangle against each other: perps, Cramer's rule and Plücker products.
#include "geometry/intersect_ray_triangle_cramer.h"
#include "geometry/intersect_ray_triangle_plucker.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

constexpr int wholeLimit = 6;

Rational quarters(RandomNumbers &random, int low, int high) {
  return Rational(random.integer(low, high)) / 4;
}

Rational someScale(RandomNumbers &random) {
  return Rational(random.integer(1, 4) * (random.integer(0, 1) == 0 ? 1 : -1)) / random.integer(1, 3);
}

/// Mostly a proper one; else with corners that coincide or lie on one line.
Triangle<Rational> someTriangle(RandomNumbers &random) {
  Triangle<Rational> triangle{random.wholeVector(wholeLimit), random.wholeVector(wholeLimit),
                              random.wholeVector(wholeLimit)};
  const int kind = random.integer(0, 19);
  if (kind == 0)
    triangle.p1 = triangle.p0;
  else if (kind == 1)
    triangle.p2 = triangle.p1;
  else if (kind == 2)
    triangle.p2 = triangle.p0;
  else if (kind == 3)
    triangle.p2 = pointOf(triangle, quarters(random, -8, 8), Rational(0));
  return triangle;
}

ExactVec3 cornerOf(const Triangle<Rational> &triangle, int index) {
  return index == 0 ? triangle.p0 : index == 1 ? triangle.p1 : triangle.p2;
}

ExactVec3 pointOnEdge(const Triangle<Rational> &triangle, RandomNumbers &random) {
  const int corner = random.integer(0, 2);
  const ExactVec3 from = cornerOf(triangle, corner);
  return from + (cornerOf(triangle, (corner + 1) % 3) - from) * quarters(random, 1, 3);
}

ExactVec3 pointInPlane(const Triangle<Rational> &triangle, RandomNumbers &random) {
  return pointOf(triangle, quarters(random, -2, 5), quarters(random, -2, 5));
}

ExactVec3 directionInPlane(const Triangle<Rational> &triangle, RandomNumbers &random) {
  return pointInPlane(triangle, random) - triangle.p0;
}

/// Towards or away from the target, or across it where origin and target are the same.
Ray<Rational> rayAt(const ExactVec3 &target, RandomNumbers &random) {
  const ExactVec3 origin = random.wholeVector(wholeLimit);
  if (origin == target)
    return {origin, random.nonZeroWholeVector(wholeLimit)};
  return {origin, (target - origin) * someScale(random)};
}

Ray<Rational> someRay(const Triangle<Rational> &triangle, RandomNumbers &random) {
  switch (random.integer(0, 8)) {
  case 0:
    return rayAt(cornerOf(triangle, random.integer(0, 2)), random);
  case 1:
  case 2:
    return rayAt(pointOnEdge(triangle, random), random);
  case 3:
  case 4:
    return rayAt(pointInPlane(triangle, random), random);
  case 5:
    return {random.wholeVector(wholeLimit), directionInPlane(triangle, random)};
  case 6:
    return {pointInPlane(triangle, random), directionInPlane(triangle, random)};
  case 7:
    return {pointInPlane(triangle, random), random.wholeVector(wholeLimit)};
  default:
    return {random.wholeVector(wholeLimit), random.wholeVector(wholeLimit)};
  }
}

bool areSame(const FaceLocation &a, const FaceLocation &b) {
  return a.part == b.part && a.feature == b.feature;
}

/// Law (3) of Cramer's rule; laws (1) and (2) of the Plücker products.
bool methodsAgree(const Ray<Rational> &ray, const Triangle<Rational> &triangle) {
  const auto perps = intersectRayTriangle(ray, triangle);
  const auto cramer = intersectRayTriangleCramer(ray, triangle);
  const auto plucker = intersectRayTrianglePlucker(ray, triangle);
  if (perps.which != cramer.which || perps.which != plucker.which)
    return false;
  if (perps.crosses() != cramer.crosses() || perps.crosses() != plucker.crosses())
    return false;
  if (!perps.crosses())
    return true;
  return areSame(perps.location, cramer.location) && areSame(perps.location, plucker.location) &&
         perps.plane.t == cramer.t && perps.plane.t == plucker.t && perps.s == cramer.sigma &&
         perps.s == plucker.barycentric[1] && perps.tTriangle == cramer.tau &&
         perps.tTriangle == plucker.barycentric[2] && perps.plane.point == plucker.point &&
         perps.plane.point == pointAt(ray, cramer.t) &&
         perps.plane.point == pointOf(triangle, cramer.sigma, cramer.tau);
}

TEST(TriangleMethods, OnAHundredThousandRaysAndTriangles_AgreeExactly) {
  constexpr int pairs = test::effort(100'000);
  // So often each case comes up at least, that the sweep says something of all of them.
  constexpr int enough = test::atLeast(200);
  RandomNumbers random(61);
  std::map<RayTriangleCase, int> cases;
  std::map<FacePart, int> locations;
  for (int i = 0; i < pairs; ++i) {
    const Triangle<Rational> triangle = someTriangle(random);
    const Ray<Rational> ray = someRay(triangle, random);
    const auto meet = intersectRayTriangle(ray, triangle);
    ++cases[meet.which];
    if (meet.crosses())
      ++locations[meet.location.part];
    ASSERT_TRUE(methodsAgree(ray, triangle)) << "pair " << i;
  }
  for (const auto which : {RayTriangleCase::Hit, RayTriangleCase::Miss, RayTriangleCase::Behind,
                           RayTriangleCase::Parallel, RayTriangleCase::InPlane, RayTriangleCase::Coincident,
                           RayTriangleCase::Collinear, RayTriangleCase::ZeroDirection})
    EXPECT_GE(cases[which], enough) << static_cast<int>(which);
  for (const auto location : {FacePart::Interior, FacePart::Edge, FacePart::Vertex, FacePart::Outside})
    EXPECT_GE(locations[location], enough) << static_cast<int>(location);
}

TEST(TriangleMethods, OnLargeFractions_AgreeExactly) {
  RandomNumbers random(62);
  for (int i = 0; i < test::effort(800); ++i) {
    const Rational scale = powerOfTen(random.integer(-30, 30)) / 7;
    const Triangle<Rational> triangle{random.vector() * scale, random.vector() * scale,
                                      random.vector() * scale};
    const ExactVec3 target = pointInPlane(triangle, random);
    const Ray<Rational> ray{target - random.vector() * scale, random.vector()};
    ASSERT_TRUE(methodsAgree(ray, triangle)) << "pair " << i;
  }
}

TEST(Cramer, AnyRayAndTriangle_HasTheDeterminantsOfItsColumns) {
  const auto determinant = [](const ExactVec3 &a, const ExactVec3 &b, const ExactVec3 &c) {
    return a.x * (b.y * c.z - c.y * b.z) - b.x * (a.y * c.z - c.y * a.z) + c.x * (a.y * b.z - b.y * a.z);
  };
  RandomNumbers random(63);
  for (int i = 0; i < test::effort(2000); ++i) {
    const Triangle<Rational> triangle = someTriangle(random);
    const Ray<Rational> ray = someRay(triangle, random);
    const auto cramer = intersectRayTriangleCramer(ray, triangle);
    const ExactVec3 toS = triangle.p0 - triangle.p1;
    const ExactVec3 toT = triangle.p0 - triangle.p2;
    const ExactVec3 toO = triangle.p0 - ray.origin;
    EXPECT_EQ(cramer.det, determinant(toS, toT, ray.direction));
    EXPECT_EQ(cramer.detSigma, determinant(toO, toT, ray.direction));
    EXPECT_EQ(cramer.detTau, determinant(toS, toO, ray.direction));
    EXPECT_EQ(cramer.detT, determinant(toS, toT, toO));
    EXPECT_EQ(ExactVec3(toS * cramer.detSigma + toT * cramer.detTau + ray.direction * cramer.detT),
              ExactVec3(toO * cramer.det));                              // law (1)
    EXPECT_EQ(cramer.det, dot(ray.direction, perpsOf(triangle).normal)); // law (2)
  }
}

TEST(PluckerProducts, AnyRayAndTriangle_ObeyTheirLaws) {
  RandomNumbers random(190);
  int inPlane = 0;
  for (int i = 0; i < test::effort(3000); ++i) {
    const Triangle<Rational> triangle = someTriangle(random);
    const Ray<Rational> ray = someRay(triangle, random);
    const auto products = pluckerProducts(ray, triangle);
    for (int edge = 0; edge < 3; ++edge) {
      const ExactVec3 from = cornerOf(triangle, (edge + 1) % 3) - ray.origin;
      const ExactVec3 to = cornerOf(triangle, (edge + 2) % 3) - ray.origin;
      EXPECT_EQ(products[static_cast<std::size_t>(edge)], dot(ray.direction, cross(from, to))); // law (1)
    }
    const ExactVec3 normal = perpsOf(triangle).normal;
    EXPECT_EQ(products[0] + products[1] + products[2], dot(ray.direction, normal)); // law (2)

    const bool inItsPlane =
        dot(ray.direction, normal) == 0 && dot(ExactVec3(ray.origin - triangle.p0), normal) == 0;
    const bool allZero = products == std::array<Rational, 3>{};
    if (shapeOf(triangle) == TriangleShape::Proper && !isZero(ray.direction)) {
      EXPECT_EQ(allZero, inItsPlane); // law (3)
      inPlane += allZero ? 1 : 0;
    }

    const Rational k = random.nonZeroRational(3);
    const Ray<Rational> moved{pointAt(ray, k), ray.direction};
    EXPECT_EQ(pluckerProducts(moved, triangle), products); // law (4)
    const auto scaled = pluckerProducts({ray.origin, ray.direction * k}, triangle);
    for (std::size_t edge = 0; edge < 3; ++edge)
      EXPECT_EQ(scaled[edge], products[edge] * k);
  }
  EXPECT_GT(inPlane, test::effort(100));
}

TEST(PluckerProducts, Normalized_AreTheBarycentricCoordinatesAndSumToOne) {
  RandomNumbers random(64);
  for (int i = 0; i < test::effort(2000); ++i) {
    const Triangle<Rational> triangle = random.properTriangle();
    const Rational s = random.rational(2);
    const Rational t = random.rational(2);
    const ExactVec3 direction = random.nonZeroVector();
    const Ray<Rational> ray{pointOf(triangle, s, t) - direction, direction};
    const auto plucker = intersectRayTrianglePlucker(ray, triangle);
    if (!plucker.crosses())
      continue;
    EXPECT_EQ(plucker.barycentric[0], 1 - s - t);
    EXPECT_EQ(plucker.barycentric[1], s);
    EXPECT_EQ(plucker.barycentric[2], t);
    EXPECT_EQ(plucker.sum, dot(direction, perpsOf(triangle).normal));
    EXPECT_EQ(plucker.t, 1);
  }
}

TEST(PluckerProducts, LineThroughATriangle_PassesAllEdgesOnOneSideAndTurnedOnTheOther) {
  const Triangle<Rational> triangle{ExactVec3(0, 0, 0), ExactVec3(4, 0, 0), ExactVec3(0, 4, 0)};
  const std::array<Rational, 3> up{4, 4, 8};
  const std::array<Rational, 3> down{-4, -4, -8};
  EXPECT_EQ(pluckerProducts({ExactVec3(1, 2, 3), ExactVec3(0, 0, 1)}, triangle), up);
  EXPECT_EQ(pluckerProducts({ExactVec3(1, 2, 3), ExactVec3(0, 0, -1)}, triangle), down);
}

TEST(TriangleMethods, DoublesOnSmallIntegers_GiveTheSameProductsAndTheNearestT) {
  // Products of integers this small are integers that a double holds, so only the last division rounds.
  RandomNumbers random(65);
  for (int i = 0; i < test::effort(5000); ++i) {
    const Triangle<Rational> triangle{random.wholeVector(50), random.wholeVector(50), random.wholeVector(50)};
    const Ray<Rational> ray{random.wholeVector(50), random.wholeVector(50)};
    const Triangle<double> roundedTriangle{toDouble(triangle.p0), toDouble(triangle.p1),
                                           toDouble(triangle.p2)};
    const Ray<double> roundedRay{toDouble(ray.origin), toDouble(ray.direction)};
    const auto exact = intersectRayTriangleCramer(ray, triangle);
    const auto rounded = intersectRayTriangleCramer(roundedRay, roundedTriangle);
    EXPECT_EQ(rounded.det, toDouble(exact.det));
    EXPECT_EQ(rounded.detT, toDouble(exact.detT));
    EXPECT_EQ(rounded.crosses(), exact.crosses());
    EXPECT_EQ(rounded.t, toDouble(exact.t));
    EXPECT_EQ(rounded.sigma, toDouble(exact.sigma));
    const auto exactProducts = pluckerProducts(ray, triangle);
    const auto roundedProducts = pluckerProducts(roundedRay, roundedTriangle);
    for (std::size_t edge = 0; edge < 3; ++edge)
      EXPECT_EQ(roundedProducts[edge], toDouble(exactProducts[edge]));
  }
}

} // namespace
} // namespace halfspace
