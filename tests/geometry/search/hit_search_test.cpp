#include "tests/geometry/every_search.h"

#include "geometry/decide.h"
#include "geometry/hit_all.h"
#include "tests/geometry/random_numbers.h"

#include <cmath>
#include <span>

namespace halfspace {
namespace {

INSTANTIATE_TEST_SUITE_P(Plain, EverySearch, testing::Values(plainSearch));

/// A search, and the exact loop that it is held against.
class Compared {
public:
  Compared(const SearchKind &kind, const TriangleMesh &mesh) : m_search(kind.make(mesh)) {
    for (const Triangle<double> &triangle : trianglesOf(mesh))
      m_triangles.push_back(exactly(triangle));
  }

  void expectTheFirstOfAll(const Ray<Rational> &ray) { // law (1)
    const auto all = hitAll(ray, std::span<const Triangle<Rational>>(m_triangles));
    const auto found = m_search->search(ray).nearest;
    ASSERT_EQ(found.has_value(), !all.hits.empty());
    if (!found)
      return;
    EXPECT_EQ(found->index, all.hits.front().index);
    EXPECT_EQ(found->t, all.hits.front().t);
    ++m_hits;
  }

  const std::vector<Triangle<Rational>> &triangles() const { return m_triangles; }
  int hits() const { return m_hits; }

private:
  std::unique_ptr<HitSearch> m_search;
  std::vector<Triangle<Rational>> m_triangles;
  int m_hits = 0;
};

/// Of triangles in halves, some of which are none.
TriangleMesh soup(RandomNumbers &random, int count) {
  TriangleMesh mesh;
  const auto coordinate = [&] { return random.integer(-20, 20) / 2.0; };
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(count); ++i) {
    for (int corner = 0; corner < 3; ++corner)
      mesh.corners.emplace_back(coordinate(), coordinate(), coordinate());
    mesh.triangles.push_back({3 * i, 3 * i + 1, i % 10 == 0 ? 3 * i : 3 * i + 2});
  }
  return mesh;
}

/// A bumpy square of n × n cells of two triangles each, of a size, from a corner on.
TriangleMesh terrain(RandomNumbers &random, std::uint32_t n, double size = 1, double corner = 0) {
  TriangleMesh mesh;
  for (std::uint32_t y = 0; y <= n; ++y)
    for (std::uint32_t x = 0; x <= n; ++x)
      mesh.corners.emplace_back(corner + x * size, corner + y * size,
                                corner + random.integer(0, 3) * size / 4);
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x) {
      const std::uint32_t i = y * (n + 1) + x;
      mesh.triangles.push_back({i, i + 1, i + n + 1});
      mesh.triangles.push_back({i + n + 2, i + n + 1, i + 1});
    }
  return mesh;
}

/// A place of a triangle, its corners and edges among them.
ExactVec3 placeOf(const Triangle<Rational> &triangle, RandomNumbers &random) {
  const int s = random.integer(0, 7);
  const int t = random.integer(0, 7 - s);
  return triangle.p0 + (triangle.p1 - triangle.p0) * Rational(s, 7) +
         (triangle.p2 - triangle.p0) * Rational(t, 7);
}

TEST_P(EverySearch, OfTrianglesAnywhere_FindsTheFirstOfAll) {
  RandomNumbers random(1);
  Compared compared(GetParam(), soup(random, 60));
  for (int i = 0; i < 150; ++i) {
    const ExactVec3 inDoubles = random.wholeVector(30) / Rational(4);
    const ExactVec3 direction = random.nonZeroWholeVector(9);
    ASSERT_NO_FATAL_FAILURE(compared.expectTheFirstOfAll({inDoubles, direction})) << i;
    ASSERT_NO_FATAL_FAILURE(compared.expectTheFirstOfAll({inDoubles / Rational(3), direction / Rational(7)}))
        << i;
  }
  EXPECT_GT(compared.hits(), 100);
}

TEST_P(EverySearch, AimedAtSharedEdgesAndCornersByFractions_FindsTheFirstOfAll) {
  RandomNumbers random(2);
  Compared compared(GetParam(), terrain(random, 8));
  for (int i = 0; i < 200; ++i) {
    const ExactVec3 target =
        placeOf(compared.triangles()[static_cast<std::size_t>(random.integer(0, 127))], random);
    const ExactVec3 origin = ExactVec3(random.integer(-20, 20), random.integer(-20, 20), 9) / Rational(3);
    // Every fourth ray starts on the ground.
    ASSERT_NO_FATAL_FAILURE(compared.expectTheFirstOfAll({i % 4 == 0 ? target : origin, target - origin}))
        << i;
  }
  EXPECT_EQ(compared.hits(), 200);
}

TEST_P(EverySearch, FromVeryFarAway_FindsTheFirstOfAll) {
  RandomNumbers random(3);
  Compared compared(GetParam(), terrain(random, 6));
  for (const int exponent : {10, 20, 25, 26, 27, 30, 60, 300, 1100}) {
    const Rational far = powerOfTen(exponent * 3 / 10);
    for (int i = 0; i < 20; ++i) {
      const ExactVec3 target =
          placeOf(compared.triangles()[static_cast<std::size_t>(random.integer(0, 71))], random);
      const ExactVec3 back = ExactVec3(random.integer(-9, 9), random.integer(-9, 9), 5) * far / Rational(7);
      ASSERT_NO_FATAL_FAILURE(compared.expectTheFirstOfAll({target + back, -back / far})) << exponent;
      ASSERT_NO_FATAL_FAILURE(compared.expectTheFirstOfAll({target + back, -back})) << exponent;
    }
  }
}

TEST_P(EverySearch, OfATinyMeshFarFromZero_FindsTheFirstOfAll) {
  // A third is rounded to a multiple of 2^-23 there: by more than a cell is wide.
  RandomNumbers random(4);
  for (const int exponent : {0, -10, -16, -20}) {
    Compared compared(GetParam(), terrain(random, 8, std::ldexp(1.0, exponent), 0x1p30));
    const Rational cell = exactly(std::ldexp(1.0, exponent));
    for (int i = 0; i < 100; ++i) {
      const ExactVec3 target =
          placeOf(compared.triangles()[static_cast<std::size_t>(random.integer(0, 127))], random);
      const ExactVec3 up = ExactVec3(random.integer(-3, 3), random.integer(-3, 3), 9) * cell;
      ASSERT_NO_FATAL_FAILURE(compared.expectTheFirstOfAll({target + up, -up})) << exponent;
    }
    EXPECT_EQ(compared.hits(), 100);
  }
}

TEST_P(EverySearch, TooLongOrTooShortForDoubles_FindsTheFirstOfAll) {
  RandomNumbers random(5);
  Compared compared(GetParam(), terrain(random, 4));
  for (const int exponent : {-700, -330, -310, 300, 310, 700})
    ASSERT_NO_FATAL_FAILURE(compared.expectTheFirstOfAll(
        {{Rational(4, 3), Rational(5, 3), 9}, ExactVec3(0, Rational(1, 9), -1) * powerOfTen(exponent)}));
  EXPECT_EQ(compared.hits(), 6);
}

TEST_P(EverySearch, TiesAndTrianglesThatCannotBeHit_GiveTheLowestIndexOfTheOthers) {
  // Of two that are none, one that the ray lies in, one above, and twice the one below.
  const TriangleMesh mesh{{{1, 1, 1},
                           {0, 0, 2},
                           {2, 2, 2},
                           {1, 1, 5},
                           {3, 1, 0},
                           {0, 0, 9},
                           {4, 0, 9},
                           {0, 4, 9},
                           {0, 0, 8},
                           {4, 0, 8},
                           {0, 4, 8}},
                          {{0, 0, 0}, {1, 0, 2}, {0, 3, 4}, {5, 6, 7}, {8, 9, 10}, {9, 10, 8}}};
  const auto search = GetParam().make(mesh);
  EXPECT_EQ(search->search({{1, 1, 0}, {0, 0, 1}}).nearest, (ExactNearestHit{4, 8}));
  EXPECT_EQ(search->search({{1, 1, Rational(1, 3)}, {0, 0, Rational(1, 3)}}).nearest,
            (ExactNearestHit{4, 23}));
  EXPECT_EQ(search->search({{1, 1, 10}, {0, 0, 1}}).nearest, std::nullopt);
}

TEST_P(EverySearch, OfNoTriangles_FindsNothing) {
  EXPECT_FALSE(GetParam().make({})->search({{0, 0, 0}, {0, 0, 1}}).nearest);
}

TEST(PlainHitSearch, AnyRay_AsksEveryTriangleAndNoBox) {
  RandomNumbers random(6);
  const PlainHitSearch search(terrain(random, 10));
  EXPECT_EQ(search.search({{5, 5, 9}, {0, 0, -1}}).cost, (SearchCost{0, 200}));
  EXPECT_EQ(search.search({{Rational(1, 3), 5, 9}, {0, 0, 1}}).cost, (SearchCost{0, 200}));
}

TEST(TriangleMesh, ItsTriangles_HaveTheirCorners) {
  const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}}, {{0, 1, 2}, {3, 1, 0}}};
  const auto triangles = trianglesOf(mesh);
  ASSERT_EQ(triangles.size(), 2U);
  EXPECT_EQ(triangles[1].p0, Vec3<double>(5, 5, 5));
  EXPECT_EQ(triangles[1].p1, Vec3<double>(1, 0, 0));
  EXPECT_EQ(triangles[1].p2, Vec3<double>(0, 0, 0));
}

} // namespace
} // namespace halfspace
