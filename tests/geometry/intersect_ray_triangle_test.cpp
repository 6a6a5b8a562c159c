#include "geometry/intersect_ray_triangle.h"
#include "tests/effort.h"
#include "tests/geometry/random_numbers.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

const Triangle<Rational> corner{ExactVec3(0, 0, 0), ExactVec3(4, 0, 0), ExactVec3(0, 4, 0)};

Ray<Rational> downAt(const Rational &x, const Rational &y) {
  return {ExactVec3(x, y, 3), ExactVec3(0, 0, -1)};
}

/// P0 + s·u + t·v
ExactVec3 pointIn(const Triangle<Rational> &triangle, const Rational &s, const Rational &t) {
  return triangle.p0 + (triangle.p1 - triangle.p0) * s + (triangle.p2 - triangle.p0) * t;
}

/// A ray from a random place that passes the point at t = 2 and is not parallel to the triangle.
Ray<Rational> rayThrough(const ExactVec3 &point, const Triangle<Rational> &triangle, RandomNumbers &random) {
  const ExactVec3 normal = cross(ExactVec3(triangle.p1 - triangle.p0), ExactVec3(triangle.p2 - triangle.p0));
  for (;;)
    if (const ExactVec3 direction = random.nonZeroVector(); dot(direction, normal) != 0)
      return {point - direction * Rational(2), direction};
}

void expectLocation(const FaceLocation &found, FacePart part, int feature) {
  EXPECT_EQ(found.part, part);
  EXPECT_EQ(found.feature, feature);
}

TEST(IntersectRayTriangle, RayThroughTheInside_HitsWithItsParameters) {
  const auto result = intersectRayTriangle(downAt(1, 2), corner);
  EXPECT_EQ(result.which, RayTriangleCase::Hit);
  EXPECT_EQ(result.plane.t, 3);
  EXPECT_EQ(result.plane.point, ExactVec3(1, 2, 0));
  EXPECT_EQ(result.s, Rational(1, 4));
  EXPECT_EQ(result.tTriangle, Rational(1, 2));
  EXPECT_EQ(result.perps.denominator, -256);
  EXPECT_EQ(result.perps.uPerp, ExactVec3(0, 64, 0));
  EXPECT_EQ(result.perps.vPerp, ExactVec3(-64, 0, 0));
  EXPECT_EQ(result.wu, 4);
  EXPECT_EQ(result.wv, 8);
  expectLocation(result.location, FacePart::Interior, -1);
}

TEST(IntersectRayTriangle, RayFromBehind_IsBehindOrMissesByWhereItsLineCrosses) {
  const ExactVec3 up(0, 0, 1);
  EXPECT_EQ(intersectRayTriangle({ExactVec3(1, 2, 3), up}, corner).which, RayTriangleCase::Behind);
  EXPECT_EQ(intersectRayTriangle({ExactVec3(3, 3, 3), up}, corner).which, RayTriangleCase::Miss);
  EXPECT_EQ(intersectRayTriangle(downAt(3, 3), corner).which, RayTriangleCase::Miss);
}

TEST(IntersectRayTriangle, RayAlongThePlane_IsParallelOrInThePlane) {
  const ExactVec3 along(1, 1, 0);
  EXPECT_EQ(intersectRayTriangle({ExactVec3(0, 0, 1), along}, corner).which, RayTriangleCase::Parallel);
  const auto inPlane = intersectRayTriangle({ExactVec3(9, 9, 0), along}, corner);
  EXPECT_EQ(inPlane.which, RayTriangleCase::InPlane);
  EXPECT_FALSE(inPlane.crosses());
}

TEST(IntersectRayTriangle, DegenerateInput_IsNamed) {
  const ExactVec3 a(1, 2, 3);
  const ExactVec3 b(2, 4, 6);
  const ExactVec3 c(3, 6, 9);
  const Ray<Rational> ray = downAt(1, 1);
  EXPECT_EQ(intersectRayTriangle(ray, {a, a, b}).which, RayTriangleCase::Coincident);
  EXPECT_EQ(intersectRayTriangle(ray, {b, a, b}).which, RayTriangleCase::Coincident);
  EXPECT_EQ(intersectRayTriangle(ray, {a, b, b}).which, RayTriangleCase::Coincident);
  EXPECT_EQ(intersectRayTriangle(ray, {a, a, a}).which, RayTriangleCase::Coincident);
  EXPECT_EQ(intersectRayTriangle(ray, {a, b, c}).which, RayTriangleCase::Collinear);
  EXPECT_EQ(intersectRayTriangle(ray, {b, a, c}).which, RayTriangleCase::Collinear);
  EXPECT_EQ(intersectRayTriangle({a, ExactVec3(0, 0, 0)}, corner).which, RayTriangleCase::ZeroDirection);
}

TEST(PlaceInTriangle, CornersAndEdges_AreNamedByTheirIndex) {
  const Rational half(1, 2);
  expectLocation(locationInTriangle(Rational(0), Rational(0)), FacePart::Vertex, 0);
  expectLocation(locationInTriangle(Rational(1), Rational(0)), FacePart::Vertex, 1);
  expectLocation(locationInTriangle(Rational(0), Rational(1)), FacePart::Vertex, 2);
  expectLocation(locationInTriangle(half, half), FacePart::Edge, 0);
  expectLocation(locationInTriangle(Rational(0), half), FacePart::Edge, 1);
  expectLocation(locationInTriangle(half, Rational(0)), FacePart::Edge, 2);
}

TEST(PlaceInTriangle, EdgeLineBeyondTheCorners_IsOutside) {
  expectLocation(locationInTriangle(Rational(0), Rational(2)), FacePart::Outside, -1);
  expectLocation(locationInTriangle(Rational(-1), Rational(0)), FacePart::Outside, -1);
  expectLocation(locationInTriangle(Rational(3), Rational(-2)), FacePart::Outside, -1);
}

TEST(PlaceInTriangle, PointMovedOverAnEdge_IsOnItOnlyAtZero) {
  for (int k = 1; k <= 60; ++k) {
    const Rational step = powerOfTen(-k);
    const Rational half(1, 2);
    expectLocation(locationInTriangle(step, half), FacePart::Interior, -1);
    expectLocation(locationInTriangle(Rational(-step), half), FacePart::Outside, -1);
    expectLocation(locationInTriangle(half, Rational(half - step)), FacePart::Interior, -1);
    expectLocation(locationInTriangle(half, Rational(half + step)), FacePart::Outside, -1);
    expectLocation(locationInTriangle(Rational(1 - step), Rational(0)), FacePart::Edge, 2);
    expectLocation(locationInTriangle(Rational(1 + step), Rational(0)), FacePart::Outside, -1);
  }
}

TEST(PerpsOf, AnyTriangle_ObeysTheNotesIdentities) {
  RandomNumbers random(51);
  for (int i = 0; i < test::effort(2000); ++i) {
    Triangle<Rational> triangle{random.vector(), random.vector(), random.vector()};
    if (i % 4 == 0) // the identities hold for collinear corners too
      triangle.p2 = pointIn(triangle, random.rational(), 0);
    const auto perps = perpsOf(triangle);
    EXPECT_EQ(perps.uPerp, cross(perps.normal, perps.u)); // law (1)
    EXPECT_EQ(perps.vPerp, cross(perps.normal, perps.v));
    EXPECT_EQ(dot(perps.uPerp, perps.u), 0);
    EXPECT_EQ(dot(perps.vPerp, perps.v), 0);
    EXPECT_EQ(perps.denominator, -dot(perps.normal, perps.normal)); // law (2)
    EXPECT_EQ(dot(perps.uPerp, perps.v), -perps.denominator);
    EXPECT_EQ(dot(perps.vPerp, perps.u), perps.denominator);
    const bool degenerate = shapeOf(triangle) != TriangleShape::Proper;
    EXPECT_EQ(perps.denominator.sign(), degenerate ? 0 : -1); // law (3)
    EXPECT_EQ(isZero(perps.normal), degenerate);
  }
}

TEST(IntersectRayTriangle, RayAimedAtParameters_FindsExactlyThese) {
  RandomNumbers random(52);
  for (int i = 0; i < test::effort(2000); ++i) {
    const Triangle<Rational> triangle = random.properTriangle();
    const Rational s = random.rational(2);
    const Rational t = random.rational(2);
    const auto result = intersectRayTriangle(rayThrough(pointIn(triangle, s, t), triangle, random), triangle);
    ASSERT_TRUE(result.crosses());
    EXPECT_EQ(result.plane.t, 2);
    EXPECT_EQ(result.s, s);
    EXPECT_EQ(result.tTriangle, t);
    EXPECT_EQ(result.w, ExactVec3(result.perps.u * s + result.perps.v * t)); // law (1)
    // The notes' own quotients, t = w·u⊥/v·u⊥ and s = w·v⊥/u·v⊥, give the same.
    EXPECT_EQ(Rational(dot(result.w, result.perps.uPerp) / dot(result.perps.v, result.perps.uPerp)), t);
    EXPECT_EQ(Rational(dot(result.w, result.perps.vPerp) / dot(result.perps.u, result.perps.vPerp)), s);
    const bool inside = s >= 0 && t >= 0 && s + t <= 1;
    EXPECT_EQ(result.which, inside ? RayTriangleCase::Hit : RayTriangleCase::Miss); // law (2)
  }
}

TEST(IntersectRayTriangle, RayAimedAtEdgesAndCorners_NeverSlipsThrough) {
  RandomNumbers random(53);
  for (int i = 0; i < 250; ++i) {
    const Triangle<Rational> triangle = random.properTriangle();
    const ExactVec3 corners[] = {triangle.p0, triangle.p1, triangle.p2};
    for (int vertex = 0; vertex < 3; ++vertex) {
      const ExactVec3 &next = corners[(vertex + 1) % 3];
      const ExactVec3 &last = corners[(vertex + 2) % 3];
      const auto atCorner = intersectRayTriangle(rayThrough(corners[vertex], triangle, random), triangle);
      EXPECT_EQ(atCorner.which, RayTriangleCase::Hit);
      expectLocation(atCorner.location, FacePart::Vertex, vertex);
      const ExactVec3 between = next + (last - next) * (Rational(random.integer(1, 99)) / 100);
      const auto onEdge = intersectRayTriangle(rayThrough(between, triangle, random), triangle);
      EXPECT_EQ(onEdge.which, RayTriangleCase::Hit);
      expectLocation(onEdge.location, FacePart::Edge, vertex);
    }
  }
}

TEST(IntersectRayTriangle, CornersInAnotherOrder_GiveTheSameHit) { // law (3)
  RandomNumbers random(54);
  for (int i = 0; i < 250; ++i) {
    const Triangle<Rational> triangle = random.properTriangle();
    const Ray<Rational> ray =
        rayThrough(pointIn(triangle, random.rational(1), random.rational(1)), triangle, random);
    const auto result = intersectRayTriangle(ray, triangle);
    const auto turned = intersectRayTriangle(ray, {triangle.p1, triangle.p2, triangle.p0});
    const auto flipped = intersectRayTriangle(ray, {triangle.p0, triangle.p2, triangle.p1});
    EXPECT_EQ(turned.which, result.which);
    EXPECT_EQ(turned.plane.t, result.plane.t);
    EXPECT_EQ(turned.plane.point, result.plane.point);
    EXPECT_EQ(turned.tTriangle, Rational(1 - result.s - result.tTriangle));
    EXPECT_EQ(turned.s, result.tTriangle);
    EXPECT_EQ(flipped.which, result.which);
    EXPECT_EQ(flipped.plane.t, result.plane.t);
    EXPECT_EQ(flipped.s, result.tTriangle);
    EXPECT_EQ(flipped.tTriangle, result.s);
  }
}

TEST(IntersectRayTriangle, MultipleOfTheDirection_DividesTAndKeepsThePlace) { // law (4)
  RandomNumbers random(189);
  std::map<RayTriangleCase, int> cases;
  for (int i = 0; i < 3000; ++i) {
    const Triangle<Rational> triangle{random.wholeVector(2), random.wholeVector(2), random.wholeVector(2)};
    const Ray<Rational> ray{random.wholeVector(2), random.wholeVector(2)};
    const Rational k = random.nonZeroRational(3);
    const auto result = intersectRayTriangle(ray, triangle);
    const auto scaled = intersectRayTriangle({ray.origin, ray.direction * k}, triangle);
    ++cases[result.which];
    ASSERT_EQ(scaled.crosses(), result.crosses());
    EXPECT_TRUE(k < 0 || scaled.which == result.which);
    EXPECT_EQ(scaled.plane.t, result.plane.t / k);
    EXPECT_EQ(scaled.plane.point, result.plane.point);
    expectLocation(scaled.location, result.location.part, result.location.feature);
    EXPECT_EQ(scaled.s, result.s);
    EXPECT_EQ(scaled.tTriangle, result.tTriangle);
    // Law (2).
    EXPECT_EQ(result.crosses() && result.location.part == FacePart::Outside,
              result.which == RayTriangleCase::Miss);
  }
  EXPECT_EQ(cases.size(), 8U) << "a case did not come up";
}

TEST(IntersectRayTriangle, TriangleSqueezedToALine_KeepsItsParametersUntilItIsOne) {
  const Rational s(1, 3);
  const Rational t(1, 5);
  RandomNumbers random(55);
  for (int k = 0; k <= 60; ++k) {
    const Triangle<Rational> thin{ExactVec3(1, 1, 1), ExactVec3(5, 1, 1),
                                  ExactVec3(3, Rational(1 + powerOfTen(-k)), 1)};
    const auto result = intersectRayTriangle(rayThrough(pointIn(thin, s, t), thin, random), thin);
    EXPECT_EQ(result.which, RayTriangleCase::Hit);
    EXPECT_EQ(result.s, s);
    EXPECT_EQ(result.tTriangle, t);
  }
  EXPECT_EQ(shapeOf<Rational>({ExactVec3(1, 1, 1), ExactVec3(5, 1, 1), ExactVec3(3, 1, 1)}),
            TriangleShape::Collinear);
}

TEST(IntersectRayTriangle, Doubles_AgreeWithFractionsOnPlumpTriangles) {
  RandomNumbers random(56);
  // |n|² ≥ 100 and |r·n| ≥ 1 with coordinates up to 20 keep the rounding errors of s and t far below this
  // bound.
  const double bound = 1e-7;
  for (int i = 0; i < test::effort(500); ++i) {
    const Triangle<Rational> triangle = random.properTriangle();
    const Ray<Rational> ray =
        rayThrough(pointIn(triangle, random.rational(1), random.rational(1)), triangle, random);
    const auto exact = intersectRayTriangle(ray, triangle);
    if (exact.perps.denominator > -100 || abs(exact.plane.denominator) < 1)
      continue;
    const auto rounded =
        intersectRayTriangle(Ray<double>{toDouble(ray.origin), toDouble(ray.direction)},
                             {toDouble(triangle.p0), toDouble(triangle.p1), toDouble(triangle.p2)});
    EXPECT_NEAR(rounded.plane.t, toDouble(exact.plane.t), bound);
    EXPECT_NEAR(rounded.s, toDouble(exact.s), bound);
    EXPECT_NEAR(rounded.tTriangle, toDouble(exact.tTriangle), bound);
  }
}

} // namespace
} // namespace halfspace
