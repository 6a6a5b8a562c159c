#include "geometry/intersect_ray_polygon.h"
#include "geometry/intersect_ray_triangle.h"
#include "tests/effort.h"
#include "tests/geometry/random_bodies.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <numeric>

namespace halfspace {
namespace {

PolygonShape shapeOfPolygon(const Polygon<Rational> &corners) { return shapeOf(corners); }

RayPolygon<Rational> intersect(const Ray<Rational> &ray, const Polygon<Rational> &corners) {
  return intersectRayPolygon(ray, std::span<const ExactVec3>(corners));
}

/// The corners of a plane figure, in a plane that is slanted against all axes.
Polygon<Rational> slanted(const std::vector<std::pair<int, int>> &corners) {
  Polygon<Rational> polygon;
  for (const auto &[x, y] : corners)
    polygon.push_back(ExactVec3(1, 2, 3) + ExactVec3(1, 0, 2) * Rational(x) +
                      ExactVec3(0, 1, -1) * Rational(y));
  return polygon;
}

/// Convex by the words of the format, which are law (3): from each edge all other corners lie on one side,
/// none on its line.
bool isConvexByEveryEdge(const Polygon<Rational> &corners) {
  const std::size_t count = corners.size();
  const auto points = weighted(corners);
  const auto plane = planeOf(std::span<const WeightedPoint<Rational>>(points));
  for (std::size_t i = 0; i < count; ++i) {
    const ExactVec3 edge = corners[(i + 1) % count] - corners[i];
    std::set<int> sides;
    for (std::size_t j = 0; j < count; ++j)
      if (j != i && j != (i + 1) % count)
        sides.insert(dot(cross(edge, ExactVec3(corners[j] - corners[i])), plane.normal).sign());
    if (sides.size() != 1 || sides.contains(0))
      return false;
  }
  return true;
}

TEST(PolygonShape, ConvexPolygonEitherWayRound_IsConvex) {
  const std::vector<std::pair<int, int>> corners{{0, 0}, {4, 0}, {6, 3}, {4, 6}, {0, 5}};
  EXPECT_EQ(shapeOfPolygon(slanted(corners)), PolygonShape::Convex);
  EXPECT_EQ(shapeOfPolygon(slanted({corners.rbegin(), corners.rend()})), PolygonShape::Convex);
  EXPECT_EQ(shapeOfPolygon(slanted({{0, 0}, {1, 0}, {0, 1}})), PolygonShape::Convex);
}

TEST(PolygonShape, PlanarFiguresThatAreNotConvex_AreNotConvex) {
  const std::map<std::string, std::vector<std::pair<int, int>>> figures{
      {"five-pointed star", {{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}}},
      {"bow tie", {{0, 0}, {4, 4}, {4, 0}, {0, 4}}},
      {"dent", {{0, 0}, {6, 0}, {2, 2}, {0, 6}}},
      {"repeated corner", {{0, 0}, {4, 0}, {4, 0}, {0, 4}}},
      {"last corner is the first", {{0, 0}, {4, 0}, {0, 4}, {0, 0}}},
      {"corner met twice", {{0, 0}, {4, 0}, {4, 4}, {0, 0}, {-4, 4}}},
      {"straight corner", {{0, 0}, {2, 0}, {4, 0}, {0, 4}}},
      {"straight corner at the end", {{2, 0}, {4, 0}, {0, 4}, {0, 0}}},
      {"there and back", {{0, 0}, {4, 0}, {2, 0}, {0, 4}}},
      {"triangle twice", {{0, 0}, {4, 0}, {0, 4}, {0, 0}, {4, 0}, {0, 4}}},
      {"square twice", {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}},
      {"round twice with different corners",
       {{0, 0}, {9, 0}, {9, 9}, {0, 9}, {1, 1}, {8, 1}, {8, 8}, {1, 8}}},
      {"all on one line", {{0, 0}, {1, 1}, {3, 3}, {2, 2}}},
      {"all the same", {{1, 1}, {1, 1}, {1, 1}}},
      {"two points", {{0, 0}, {1, 2}, {0, 0}, {1, 2}}}};
  for (const auto &[name, corners] : figures) {
    EXPECT_EQ(shapeOfPolygon(slanted(corners)), PolygonShape::NotConvex) << name;
    EXPECT_EQ(shapeOfPolygon(slanted({corners.rbegin(), corners.rend()})), PolygonShape::NotConvex) << name;
  }
}

TEST(PolygonShape, OneCornerOffThePlane_IsNotPlanarHoweverLittle) {
  for (int k = 0; k <= 60; ++k)
    for (std::size_t lifted = 0; lifted < 4; ++lifted) {
      Polygon<Rational> corners = slanted({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
      corners[lifted].z += powerOfTen(-k);
      EXPECT_EQ(shapeOfPolygon(corners), PolygonShape::NotPlanar);
    }
}

TEST(PolygonShape, CornerPressedIn_IsConvexUntilItIsStraight) {
  for (int k = 0; k <= 60; ++k) {
    const auto with = [&](const Rational &bulge) {
      return shapeOfPolygon({ExactVec3(0, 0, 0), ExactVec3(4, 0, 0),
                             ExactVec3(Rational(2 + bulge), Rational(2 + bulge), 0), ExactVec3(0, 4, 0)});
    };
    EXPECT_EQ(with(powerOfTen(-k)), PolygonShape::Convex);
    EXPECT_EQ(with(Rational(0)), PolygonShape::NotConvex);
    EXPECT_EQ(with(Rational(-powerOfTen(-k))), PolygonShape::NotConvex);
  }
}

TEST(PolygonShape, AnyPlanarCorners_AgreeWithLookingFromEveryEdge) {
  RandomNumbers random(111);
  int convex = 0;
  constexpr int figures = 20'000;
  for (int i = 0; i < figures; ++i) {
    std::vector<std::pair<int, int>> corners;
    for (int left = random.integer(3, 6); left > 0; --left)
      corners.emplace_back(random.integer(0, 4), random.integer(0, 4));
    const Polygon<Rational> polygon = slanted(corners);
    const bool expected = isConvexByEveryEdge(polygon);
    convex += expected ? 1 : 0;
    ASSERT_EQ(shapeOfPolygon(polygon), expected ? PolygonShape::Convex : PolygonShape::NotConvex)
        << "figure " << i;
  }
  // Both verdicts come up often.
  EXPECT_GT(convex, figures / 10);
  EXPECT_LT(convex, figures / 2);
}

TEST(PolygonShape, RandomConvexPolygons_AreConvex) {
  RandomNumbers random(112);
  for (int i = 0; i < test::effort(1000); ++i)
    EXPECT_EQ(shapeOfPolygon(randomPolygon(random)), PolygonShape::Convex);
}

TEST(PolygonShape, AnotherFirstCornerOrTheOtherWayRound_IsTheSame) { // law (1)
  RandomNumbers random(191);
  std::map<PolygonShape, int> shapes;
  for (int i = 0; i < 2000; ++i) {
    Polygon<Rational> corners;
    for (int left = random.integer(3, 5); left > 0; --left)
      corners.emplace_back(random.integer(0, 2), random.integer(0, 2), i % 4 == 0 ? random.integer(0, 1) : 0);
    const PolygonShape shape = shapeOfPolygon(corners);
    ++shapes[shape];
    for (std::size_t first = 0; first < corners.size(); ++first) {
      std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      ASSERT_EQ(shapeOfPolygon(corners), shape) << "figure " << i;
      ASSERT_EQ(shapeOfPolygon({corners.rbegin(), corners.rend()}), shape) << "figure " << i;
    }
    if (corners.size() == 3) { // law (2)
      const auto triangle = shapeOf(Triangle<Rational>{corners[0], corners[1], corners[2]});
      EXPECT_EQ(shape, triangle == TriangleShape::Proper ? PolygonShape::Convex : PolygonShape::NotConvex);
    }
  }
  EXPECT_EQ(shapes.size(), 3U) << "a shape did not come up";
}

TEST(PlaneOfPolygon, AnyPlanarCorners_LieInItAndItIsNoneOnOneLine) {
  RandomNumbers random(192);
  int onOneLine = 0;
  for (int i = 0; i < test::effort(1000); ++i) {
    std::vector<std::pair<int, int>> figure;
    for (int left = random.integer(3, 5); left > 0; --left)
      figure.emplace_back(random.integer(0, 2), random.integer(0, 2));
    const auto corners = slanted(figure);
    const auto points = weighted(corners);
    const auto plane = planeOf(std::span<const WeightedPoint<Rational>>(points));
    bool allOnOneLine = true;
    for (const ExactVec3 &a : corners) {
      EXPECT_EQ(evaluate(plane, a), 0); // law (1)
      for (const ExactVec3 &b : corners)
        allOnOneLine = allOnOneLine && isZero(cross(ExactVec3(a - corners[0]), ExactVec3(b - corners[0])));
    }
    EXPECT_EQ(isZero(plane.normal), allOnOneLine); // law (2)
    onOneLine += allOnOneLine ? 1 : 0;
  }
  EXPECT_GT(onOneLine, test::effort(100));
}

TEST(PlaneOfPolygon, ConvexPolygon_GoesCounterclockwiseAroundItsNormal) { // law (3)
  RandomNumbers random(193);
  for (int i = 0; i < test::effort(500); ++i) {
    const Polygon<Rational> corners = randomPolygon(random);
    const auto points = weighted(corners);
    const auto plane = planeOf(std::span<const WeightedPoint<Rational>>(points));
    for (std::size_t j = 0; j + 2 < corners.size(); ++j)
      EXPECT_GT(dot(plane.normal,
                    cross(ExactVec3(corners[j + 1] - corners[j]), ExactVec3(corners[j + 2] - corners[j]))),
                0);
  }
}

/// The same by a fan of triangles from corner 0: what is a diagonal there is inside here.
FaceLocation locationByFan(const Ray<Rational> &ray, const Polygon<Rational> &corners) {
  const auto last = static_cast<int>(corners.size()) - 1;
  for (int i = 1; i < last; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const FaceLocation location =
        intersectRayTriangle(ray, {corners[0], corners[at], corners[at + 1]}).location;
    switch (location.part) {
    case FacePart::Outside:
      continue;
    case FacePart::Interior:
      return {FacePart::Interior, -1};
    case FacePart::Vertex:
      return {FacePart::Vertex, location.feature == 0 ? 0 : i + location.feature - 1};
    case FacePart::Edge:
      if (location.feature == 0)
        return {FacePart::Edge, i};
      if (location.feature == 2 && i == 1)
        return {FacePart::Edge, 0};
      if (location.feature == 1 && i + 1 == last)
        return {FacePart::Edge, last};
      return {FacePart::Interior, -1};
    }
  }
  return {};
}

/// A corner, a point of an edge or of its line beyond, or any point of the plane.
ExactVec3 someTarget(const Polygon<Rational> &corners, RandomNumbers &random) {
  const std::size_t count = corners.size();
  const auto i = static_cast<std::size_t>(random.integer(0, static_cast<int>(count) - 1));
  const ExactVec3 &corner = corners[i];
  const ExactVec3 along = corners[(i + 1) % count] - corner;
  const ExactVec3 across = corners[(i + 2) % count] - corner;
  switch (random.integer(0, 3)) {
  case 0:
    return corner;
  case 1:
    return corner + along * (Rational(random.integer(-2, 6)) / 4);
  case 2:
    return corner + across * (Rational(random.integer(0, 4)) / 4);
  default:
    return corner + along * (Rational(random.integer(-4, 12)) / 8) +
           across * (Rational(random.integer(-4, 12)) / 8);
  }
}

TEST(IntersectRayPolygon, RayAimedAtSomePlace_FindsItAsAFanOfTrianglesDoes) {
  RandomNumbers random(113);
  std::map<FacePart, int> locations;
  for (int i = 0; i < 5000; ++i) {
    const Polygon<Rational> corners = randomPolygon(random);
    const ExactVec3 target = someTarget(corners, random);
    const ExactVec3 direction = random.nonZeroWholeVector(6);
    const Rational t = random.rational(2);
    const Ray<Rational> ray{target - direction * t, direction};
    const auto meet = intersect(ray, corners);
    if (!meet.crosses())
      continue;
    const FaceLocation expected = locationByFan(ray, corners);
    ++locations[meet.location.part];
    ASSERT_EQ(meet.location.part, expected.part) << "pair " << i;
    ASSERT_EQ(meet.location.feature, expected.feature) << "pair " << i;
    EXPECT_EQ(meet.t, t);
    EXPECT_EQ(meet.point, target); // law (2)
    EXPECT_EQ(meet.which, expected.part == FacePart::Outside ? RayPolygonCase::Miss
                          : t < 0                            ? RayPolygonCase::Behind
                                                             : RayPolygonCase::Hit);
  }
  EXPECT_EQ(locations.size(), 4U) << "a place did not come up";
}

TEST(IntersectRayPolygon, Products_AreThoseWithTheEdgesAndSumToNoMoreThanTwiceTheArea) { // law (1)
  RandomNumbers random(114);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Polygon<Rational> corners = randomPolygon(random);
    const Ray<Rational> ray{random.wholeVector(6), random.nonZeroWholeVector(6)};
    const auto meet = intersect(ray, corners);
    ASSERT_EQ(meet.products.size(), corners.size());
    Rational sum = 0;
    ExactVec3 area(0, 0, 0);
    for (std::size_t edge = 0; edge < corners.size(); ++edge) {
      const ExactVec3 &from = corners[edge];
      const ExactVec3 &to = corners[(edge + 1) % corners.size()];
      EXPECT_EQ(meet.products[edge],
                dot(cross(ExactVec3(from - ray.origin), ExactVec3(to - ray.origin)), ray.direction));
      sum += meet.products[edge];
      area += cross(from, to);
    }
    EXPECT_EQ(sum, dot(area, ray.direction));
  }
}

TEST(IntersectRayPolygon, Triangle_IsMetAsByThePerps) { // law (3)
  RandomNumbers random(194);
  std::map<FacePart, int> locations;
  for (int i = 0; i < 4000; ++i) {
    const Polygon<Rational> corners{random.wholeVector(2), random.wholeVector(2), random.wholeVector(2)};
    const Triangle<Rational> triangle{corners[0], corners[1], corners[2]};
    if (shapeOf(triangle) != TriangleShape::Proper)
      continue;
    const Ray<Rational> ray{random.wholeVector(2), random.wholeVector(2)};
    const auto meet = intersect(ray, corners);
    const auto perps = intersectRayTriangle(ray, triangle);
    ASSERT_EQ(meet.crosses(), perps.crosses());
    if (!meet.crosses())
      continue;
    ++locations[meet.location.part];
    EXPECT_EQ(meet.which == RayPolygonCase::Hit, perps.which == RayTriangleCase::Hit);
    EXPECT_EQ(meet.which == RayPolygonCase::Behind, perps.which == RayTriangleCase::Behind);
    EXPECT_EQ(meet.t, perps.plane.t);
    EXPECT_EQ(meet.point, perps.plane.point);
    EXPECT_EQ(meet.location.part, perps.location.part);
    const bool isEdge = perps.location.part == FacePart::Edge;
    EXPECT_EQ(meet.location.feature, isEdge ? (perps.location.feature + 1) % 3 : perps.location.feature);
  }
  EXPECT_EQ(locations.size(), 4U) << "a place did not come up";
}

TEST(IntersectRayPolygon, CornersTheOtherWayRound_GiveTheSameAndNegativeProducts) { // law (4)
  RandomNumbers random(195);
  for (int i = 0; i < test::effort(1000); ++i) {
    const Polygon<Rational> corners = randomPolygon(random);
    const Polygon<Rational> reversed(corners.rbegin(), corners.rend());
    const ExactVec3 direction = random.wholeVector(4);
    const Ray<Rational> ray{someTarget(corners, random) - direction * random.rational(2), direction};
    const auto meet = intersect(ray, corners);
    const auto back = intersect(ray, reversed);
    EXPECT_EQ(back.which, meet.which);
    EXPECT_EQ(back.t, meet.t);
    EXPECT_EQ(back.point, meet.point);
    EXPECT_EQ(back.location.part, meet.location.part);
    const std::size_t count = corners.size();
    for (std::size_t edge = 0; edge < count; ++edge)
      EXPECT_EQ(back.products[edge], -meet.products[(2 * count - 2 - edge) % count]);
  }
}

TEST(PlaceByProducts, LineTurnedRoundOrAnotherFirstEdge_IsTheSamePlace) {
  RandomNumbers random(196);
  std::map<FacePart, int> locations;
  for (int i = 0; i < 2000; ++i) {
    const Polygon<Rational> corners = randomPolygon(random);
    const ExactVec3 direction = random.nonZeroWholeVector(4);
    const auto meet = intersect({someTarget(corners, random) - direction, direction}, corners);
    if (!meet.crosses())
      continue;
    ++locations[meet.location.part];
    auto products = meet.products;
    const auto locate = [&](bool withNormal) {
      return locationByProducts(std::span<const Rational>(products), withNormal);
    };
    // The sum is direction·(twice the area vector).
    const bool withNormal = std::accumulate(products.begin(), products.end(), Rational(0)) > 0;
    EXPECT_EQ(locate(withNormal).part, meet.location.part);
    const int count = static_cast<int>(products.size());
    for (int first = 1; first < count; ++first) { // law (2)
      std::rotate(products.begin(), products.begin() + 1, products.end());
      const auto moved = locate(withNormal);
      EXPECT_EQ(moved.part, meet.location.part);
      EXPECT_EQ(moved.feature < 0 ? -1 : (moved.feature + first) % count, meet.location.feature);
    }
    std::rotate(products.begin(), products.begin() + 1, products.end());
    std::transform(products.begin(), products.end(), products.begin(), std::negate());
    EXPECT_EQ(locate(!withNormal).part, meet.location.part); // law (1)
    EXPECT_EQ(locate(!withNormal).feature, meet.location.feature);
  }
  EXPECT_EQ(locations.size(), 4U) << "a place did not come up";
}

TEST(IntersectRayPolygon, RayAlongThePlane_IsParallelOrInThePlane) {
  const Polygon<Rational> square{ExactVec3(0, 0, 1), ExactVec3(2, 0, 1), ExactVec3(2, 2, 1),
                                 ExactVec3(0, 2, 1)};
  const ExactVec3 along(1, 1, 0);
  EXPECT_EQ(intersect({ExactVec3(0, 0, 0), along}, square).which, RayPolygonCase::Parallel);
  EXPECT_EQ(intersect({ExactVec3(9, 0, 1), along}, square).which, RayPolygonCase::InPlane);
  EXPECT_EQ(intersect({ExactVec3(1, 1, 1), along}, square).which, RayPolygonCase::InPlane);
  EXPECT_EQ(intersect({ExactVec3(1, 1, 0), ExactVec3(0, 0, 0)}, square).which, RayPolygonCase::ZeroDirection);
}

TEST(IntersectRayPolygon, Doubles_AgreeWithFractionsOnSmallIntegers) {
  // Products of integers this small are integers that a double holds, so only the last division rounds.
  RandomNumbers random(115);
  const std::vector<Vec3<double>> rounded{{0, 0, 0}, {4, 0, 0}, {6, 3, 0}, {4, 6, 0}, {0, 5, 0}};
  Polygon<Rational> exact;
  for (const auto &corner : rounded)
    exact.emplace_back(exactly(corner.x), exactly(corner.y), exactly(corner.z));
  for (int i = 0; i < test::effort(2000); ++i) {
    const Ray<Rational> ray{random.wholeVector(8), random.nonZeroWholeVector(8)};
    const auto fractions = intersect(ray, exact);
    const auto doubles = intersectRayPolygon(Ray<double>{toDouble(ray.origin), toDouble(ray.direction)},
                                             std::span<const Vec3<double>>(rounded));
    EXPECT_EQ(doubles.which, fractions.which);
    EXPECT_EQ(doubles.location.part, fractions.location.part);
    EXPECT_EQ(doubles.location.feature, fractions.location.feature);
    EXPECT_EQ(doubles.t, toDouble(fractions.t));
  }
}

} // namespace
} // namespace halfspace
