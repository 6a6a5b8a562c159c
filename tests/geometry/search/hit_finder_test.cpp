#include "geometry/search/hit_finder.h"
#include "geometry/search/make_hit_search.h"

#include "geometry/decide.h"
#include "geometry/hit_all.h"
#include "tests/effort.h"
#include "tests/geometry/tree_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace halfspace {
namespace {

using Triangles = std::vector<Triangle<double>>;

INSTANTIATE_TEST_SUITE_P(Tree, EverySearch, testing::Values(treeSearch));

class Scenes {
public:
  explicit Scenes(std::uint64_t seed) : m_engine(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(m_engine);
  }
  std::size_t index(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(m_engine);
  }
  Vec3<double> vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }

  Triangles soup(std::size_t count, const Vec3<double> &middle) {
    Triangles triangles;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3<double> corner = middle + vector(10);
      triangles.push_back({corner, corner + vector(3), corner + vector(3)});
    }
    return triangles;
  }

private:
  std::mt19937_64 m_engine;
};

/// A bumpy square of n × n cells over [0, n]², two triangles each: every edge inside belongs to two.
Triangles terrain(Scenes &scenes, int n, const Vec3<double> &corner) {
  const auto side = static_cast<std::size_t>(n) + 1;
  std::vector<Vec3<double>> points;
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= n; ++x)
      points.push_back(corner + Vec3<double>(x, y, scenes.uniform(0, 0.5)));
  Triangles triangles;
  for (std::size_t y = 0; y + 1 < side; ++y)
    for (std::size_t x = 0; x + 1 < side; ++x) {
      const std::size_t i = y * side + x;
      triangles.push_back({points[i], points[i + 1], points[i + side]});
      triangles.push_back({points[i + side + 1], points[i + side], points[i + 1]});
    }
  return triangles;
}

void expectAsTheExactLoop(const HitFinder &finder, const Triangles &triangles, const Ray<double> &ray) {
  std::vector<Triangle<Rational>> exact;
  for (const Triangle<double> &triangle : triangles)
    exact.push_back(exactly(triangle));
  const auto all = hitAll(exactly(ray), std::span<const Triangle<Rational>>(exact));
  const auto found = finder.find(ray);
  ASSERT_EQ(found.has_value(), !all.hits.empty());
  if (!found)
    return;
  EXPECT_EQ(found->index, all.hits.front().index); // law (1)
  const double t = toDouble(all.hits.front().t);
  EXPECT_NEAR(found->t, t, std::abs(t) * hitPrecision); // law (4)
}

TEST(HitFinder, RandomTriangles_AgreesWithTheExactLoop) {
  Scenes scenes(1);
  for (const Vec3<double> middle : {Vec3<double>(0), Vec3<double>(1e6, -1e6, 3e5)}) {
    const Triangles triangles = scenes.soup(60, middle);
    const HitFinder finder(triangles);
    for (int i = 0; i < 60; ++i)
      ASSERT_NO_FATAL_FAILURE(
          expectAsTheExactLoop(finder, triangles, {middle + scenes.vector(15), scenes.vector(1)}));
  }
}

TEST(HitFinder, AimedAtSharedEdgesAndCorners_NoRaySlipsThrough) { // law (2)
  Scenes scenes(2);
  for (const Vec3<double> corner : {Vec3<double>(0), Vec3<double>(1e6, 1e6, 0)}) {
    const Triangles triangles = terrain(scenes, 12, corner);
    const HitFinder finder(triangles);
    for (int i = 0; i < test::effort(20000); ++i) {
      // Straight down on a whole x, or a whole y: on an edge exactly, whatever the height.
      const double along = scenes.uniform(0, 12);
      const auto whole = static_cast<double>(scenes.index(13));
      const Vec3<double> above = i % 2 == 0 ? Vec3<double>(whole, along, 5) : Vec3<double>(along, whole, 5);
      ASSERT_TRUE(finder.find({corner + above, {0, 0, -1}})) << i;
    }
  }
}

TEST(HitFinder, AimedAtCornersFromAnywhere_AgreesWithTheExactLoop) {
  Scenes scenes(3);
  const Triangles triangles = terrain(scenes, 5, {0, 0, 0});
  const HitFinder finder(triangles);
  for (int i = 0; i < 200; ++i) {
    const Vec3<double> target = triangles[scenes.index(triangles.size())].p1;
    const Vec3<double> origin = scenes.vector(20);
    ASSERT_NO_FATAL_FAILURE(expectAsTheExactLoop(finder, triangles, {origin, target - origin}));
  }
}

TEST(HitFinder, RaysOverFractionsFromVeryFarAway_AskFewTriangles) {
  Scenes scenes(7);
  const Triangles triangles = terrain(scenes, 40, {0, 0, 0});
  const HitFinder finder(triangles);
  for (const int exponent : {3, 9, 18, 27}) {
    const Vec3<Rational> way = Vec3<Rational>(Rational(1, 3), Rational(2, 3), 1) * powerOfTen(exponent);
    const Vec3<Rational> target(Rational(61, 3), Rational(50, 3), 0);
    const SearchResult result = finder.search({target + way, -way});
    EXPECT_TRUE(result.nearest) << exponent;
    EXPECT_LT(result.cost.triangles, triangles.size() / 20) << exponent;
  }
}

TEST(HitFinder, TrianglesAtTheSamePlace_GiveTheLowestIndex) { // law (3)
  const Triangle<double> low{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}};
  const Triangle<double> high{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
  const HitFinder finder(Triangles{high, low, low, high, low});
  const auto hit = finder.find({{1, 1, 0}, {0, 0, 0.5}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->index, 1u);
  EXPECT_EQ(hit->t, 2);
}

TEST(HitFinder, HitsThatDoublesCannotTellApart_AreOrderedExactly) {
  // One crosses the axis at z = 3, the other a hair lower.
  const double hair = std::nextafter(3.0, 0.0);
  const Triangle<double> at{{3, 0, 3}, {-3, 3, 3}, {-3, -3, 3}};
  const Triangle<double> lower{{3, 0, hair}, {-3, 3, hair}, {-3, -3, hair}};
  const HitFinder finder(Triangles{at, lower});
  const auto hit = finder.find({{0, 0, -1e3}, {0, 0, 1e-3}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->index, 1u);
}

TEST(HitFinder, DegenerateAndInPlaneTriangles_ArePassedOver) { // law (3)
  const Triangle<double> point{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  const Triangle<double> line{{0, 0, 2}, {1, 1, 2}, {2, 2, 2}};
  const Triangle<double> inPlane{{1, 1, 0}, {1, 1, 5}, {3, 1, 0}};
  const Triangle<double> far{{0, 0, 9}, {4, 0, 9}, {0, 4, 9}};
  const HitFinder finder(Triangles{point, line, inPlane, far});
  const auto hit = finder.find({{1, 1, 0}, {0, 0, 1}});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->index, 3u);
}

TEST(HitFinder, BehindOrBeside_FindsNothing) {
  const HitFinder finder(Triangles{{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}});
  EXPECT_FALSE(finder.find({{1, 1, 2}, {0, 0, 1}}));
  EXPECT_FALSE(finder.find({{5, 5, 0}, {0, 0, 1}}));
  EXPECT_TRUE(finder.find({{1, 1, 1}, {0, 0, 1}})); // t = 0
}

TEST(HitFinder, NoTriangles_FindsNothing) {
  EXPECT_FALSE(HitFinder(Triangles{}).find({{0, 0, 0}, {0, 0, 1}}));
}

TEST(HitFinder, SceneOfOneUnitInTheLastPlace_AgreesWithTheExactLoop) {
  // Its middle is no double: it is rounded to a corner.
  const double low = 0x1p20;
  const double high = std::nextafter(low, 2 * low);
  const Triangles triangles{{{high, low, low}, {high, high, low}, {high, high, high}},
                            {{low, low, low}, {low, high, low}, {low, high, high}}};
  const HitFinder finder(triangles);
  for (const Vec3<double> &direction : {Vec3<double>(-1, -0.375, -0.375), Vec3<double>(-1, 0, 0)})
    ASSERT_NO_FATAL_FAILURE(expectAsTheExactLoop(
        finder, triangles, {Vec3<double>(high, high, high) - direction * 0x1p-20, direction}));
}

TEST(HitFinder, FarAwayHugeAndTiny_AgreesWithTheExactLoop) {
  Scenes scenes(4);
  for (const double size : {1e-30, 1e-9, 1.0, 1e9, 1e30, 1e250}) {
    Triangles triangles = scenes.soup(30, Vec3<double>(0));
    for (Triangle<double> &triangle : triangles)
      triangle = {triangle.p0 * size, triangle.p1 * size, triangle.p2 * size};
    const HitFinder finder(triangles);
    for (const double away : {1.0, 1e4, 1e9})
      for (int i = 0; i < 10; ++i) {
        const Triangle<double> &aim = triangles[scenes.index(triangles.size())];
        const Vec3<double> origin = scenes.vector(20) * (size * away);
        const Vec3<double> target = (aim.p0 + aim.p1 + aim.p2) / 3.0;
        ASSERT_NO_FATAL_FAILURE(expectAsTheExactLoop(finder, triangles, {origin, target - origin})) << size;
      }
  }
}

TEST(HitFinder, TrianglesOfAllSizesTogether_AgreesWithTheExactLoop) {
  // From as large as the scene down to what floats cannot tell from a point.
  Scenes scenes(5);
  Triangles triangles;
  for (int i = 0; i < 120; ++i) {
    const double size = std::ldexp(1.0, -i / 3);
    const Vec3<double> corner = scenes.vector(1);
    triangles.push_back({corner, corner + scenes.vector(size), corner + scenes.vector(size)});
  }
  const HitFinder finder(triangles);
  for (int i = 0; i < 240; ++i) {
    const auto &[p0, p1, p2] = triangles[scenes.index(triangles.size())];
    const double share = i % 3 == 0 ? 0 : scenes.uniform(0, 1); // corners, edges, insides
    const Vec3<double> target = p0 + (p1 - p0) * share + (p2 - p0) * (i % 3 == 1 ? 0 : (1 - share) / 2);
    const Vec3<double> origin = scenes.vector(4);
    ASSERT_NO_FATAL_FAILURE(expectAsTheExactLoop(finder, triangles, {origin, target - origin})) << i;
  }
}

/// The lowest index of the smallest t, asked one triangle after the other.
std::optional<std::size_t> nearestOfEach(const Triangles &triangles, const Ray<double> &ray) {
  std::optional<std::size_t> nearest;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (decideRayTriangle(ray, triangles[i]).which == RayTriangleCase::Hit &&
        (!nearest || exactT(ray, triangles[i]) < exactT(ray, triangles[*nearest])))
      nearest = i;
  return nearest;
}

TEST(HitFinder, TreeOfManyLevels_FindsTheNearestOfEach) {
  Scenes scenes(6);
  Triangles triangles = terrain(scenes, 40, {0, 0, 0});
  const Triangles above = scenes.soup(2000, {20, 20, 10});
  triangles.insert(triangles.end(), above.begin(), above.end());
  const HitFinder finder(triangles);
  int hits = 0;
  for (int i = 0; i < test::effort(1000); ++i) {
    const Ray<double> ray{{scenes.uniform(-10, 50), scenes.uniform(-10, 50), scenes.uniform(-5, 30)},
                          i % 4 == 0 ? Vec3<double>(0, i % 8 == 0 ? 0.5 : 0, -1) : scenes.vector(1)};
    const auto expected = nearestOfEach(triangles, ray);
    const auto found = finder.find(ray);
    ASSERT_EQ(found.has_value(), expected.has_value()) << i;
    if (found) {
      ASSERT_EQ(found->index, *expected) << i;
      ++hits;
    }
  }
  EXPECT_GT(hits, test::effort(200));
}

TEST(HitFinder, ShortDirectionsInWideScenes_FindTheNearestOfEach) {
  // A power of two makes the scene as wide, another the direction as short, without a rounding.
  Scenes scenes(7);
  const Triangles triangles = scenes.soup(400, {0, 0, 0});
  for (const int width : {0, 60, 100, 180}) {
    Triangles wide = triangles;
    for (Triangle<double> &triangle : wide)
      for (Vec3<double> *corner : {&triangle.p0, &triangle.p1, &triangle.p2})
        *corner *= std::ldexp(1.0, width);
    const HitFinder finder(wide);
    for (const int length : {-1021, -1000, -900, -500, 0}) {
      for (int i = 0; i < 60; ++i) {
        const Ray<double> ray{scenes.vector(15), scenes.vector(1)};
        const auto expected = nearestOfEach(triangles, ray);
        const auto found =
            finder.find({ray.origin * std::ldexp(1.0, width), ray.direction * std::ldexp(1.0, length)});
        ASSERT_EQ(found.has_value(), expected.has_value()) << width << ", " << length << ", ray " << i;
        if (found && length > -1021) { // the shortest were rounded
          ASSERT_EQ(found->index, *expected) << width << ", " << length << ", ray " << i;
        }
      }
    }
  }
}

TEST(HitFinder, OnlyDegenerateTriangles_FindsNothing) {
  Triangles triangles;
  for (int i = 0; i < 50; ++i)
    triangles.push_back({{i, 0, 1}, {i, 1, 1}, {i, 3, 1}});
  EXPECT_FALSE(HitFinder(triangles).find({{7, 2, 0}, {0, 0, 1}}));
}

TEST(HitFinder, VeryManyDegenerateTrianglesInThePointAimedAt_HideNothing) {
  const Vec3<double> place(1, 1, 1);
  Triangles triangles(30'000, {place, place, place});
  for (int i = 0; i < test::effort(3000); ++i)
    triangles.push_back({place, place + Vec3<double>(i, i, 0), place - Vec3<double>(1, 1, 0)});
  triangles.push_back({{0, 0, 9}, {4, 0, 9}, {0, 4, 9}});
  const HitFinder finder(triangles);
  for (int i = 0; i < test::effort(1000); ++i)
    ASSERT_EQ(finder.find({{1, 1, 0}, {0, 0, 1}})->index, triangles.size() - 1);
}

TEST(HitFinder, VeryManyTrianglesInOnePlace_GiveTheLowestIndex) { // law (3)
  Triangles triangles(20'000, {{0, 0, 1}, {4, 0, 1}, {0, 4, 1}});
  triangles.front() = {{0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
  EXPECT_EQ(HitFinder(triangles).find({{1, 1, 0}, {0, 0, 1}})->index, 1U);
}

TEST(HitFinder, DirectionOfAnyLength_FindsTheSameTriangle) {
  const std::vector<Triangle<double>> triangles{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}},
                                                {{-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}};
  const HitFinder finder(triangles);
  for (int exponent = -1074; exponent <= 1023; ++exponent) {
    const Ray<double> ray{{0, 0, 3}, {0, 0, -std::ldexp(1.0, exponent)}};
    const auto found = finder.find(ray);
    ASSERT_TRUE(found) << exponent;
    EXPECT_EQ(found->index, 1U);
    EXPECT_EQ(found->t, std::ldexp(2.0, -exponent)) << exponent;
  }
}

TEST(HitFinder, OriginHoweverFar_FindsTheTriangle) {
  const std::vector<Triangle<double>> triangles{{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}};
  const HitFinder finder(triangles);
  for (int exponent = 0; exponent <= 1000; ++exponent) {
    const double height = std::ldexp(1.0, exponent);
    const auto found = finder.find({{0.25, 0.25, height}, {0, 0, -1}});
    ASSERT_TRUE(found) << exponent;
    EXPECT_EQ(found->t, height);
    EXPECT_FALSE(finder.find({{0.25, 0.25, height}, {0, 0, 1}})) << exponent;
  }
}

TEST(HitFinder, OfTenThousandTriangles_AsksFewOfThem) {
  Scenes scenes(8);
  const HitFinder finder(terrain(scenes, 71, {0, 0, 0}));
  for (const Rational &x : {Rational(71, 2), Rational(71, 3)}) { // in doubles, and not
    const SearchCost cost = finder.search({{x, 30, 40}, {1, 1, -10}}).cost;
    EXPECT_GT(cost.triangles, 0U);
    EXPECT_GT(cost.boxes, 0U);
    EXPECT_LT(cost.boxes + cost.triangles, 1000U);
  }
}

TEST(HitFinder, CostOfFewTriangles_CountsThoseThatAreThere) {
  for (const std::size_t count : {1U, 2U, 3U, 5U, 17U}) {
    std::vector<Triangle<double>> triangles;
    for (std::size_t i = 0; i < count; ++i) {
      const auto z = static_cast<double>(i);
      triangles.push_back({{-1, -1, z}, {1, -1, z}, {0, 1, z}});
    }
    const SearchCost cost = HitFinder(triangles).search({{0, 0, -1}, {0, 0, 1}}).cost;
    EXPECT_GE(cost.triangles, 1U);
    EXPECT_LE(cost.triangles, count);
    EXPECT_LE(cost.boxes, count) << "each box has a triangle of its own";
  }
}

TEST(MakeHitSearch, FewOrManyTriangles_AreSearchedOneByOneOrByBoxes) {
  const auto stairs = [](std::uint32_t triangles) {
    TriangleMesh mesh;
    for (std::uint32_t i = 0; i < triangles; ++i) {
      mesh.corners.insert(mesh.corners.end(), {{i, 0, i}, {i + 1, 0, i}, {i, 1, i}});
      mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return mesh;
  };
  const Ray<Rational> ray{{Rational(1, 4), Rational(1, 4), 9}, {0, 0, -1}};
  const SearchResult few = makeHitSearch(stairs(20))->search(ray);
  EXPECT_EQ(few.cost, (SearchCost{0, 20}));
  const SearchResult many = makeHitSearch(stairs(2000))->search(ray);
  EXPECT_GT(many.cost.boxes, 0U);
  EXPECT_LT(many.cost.triangles, 100U);
  EXPECT_EQ(many.nearest, few.nearest);
}

TEST(MakeHitSearch, ThatIsCancelled_IsNull_AndItsFinderAsksEachTriangle) {
  TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {}};
  mesh.triangles.resize(1000, {0, 1, 2});
  const std::atomic<bool> cancelled = true;
  EXPECT_FALSE(makeHitSearch(mesh, cancelled));
  const HitFinder finder(trianglesOf(mesh), &cancelled);
  const auto found = finder.search({{Rational(1, 4), Rational(1, 4), 9}, {0, 0, -1}});
  EXPECT_EQ(found.cost, (SearchCost{0, 1000}));
  ASSERT_TRUE(found.nearest);
  EXPECT_EQ(found.nearest->index, 0U);
}

} // namespace
} // namespace halfspace
