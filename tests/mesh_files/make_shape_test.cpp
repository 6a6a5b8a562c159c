#include "widgets/mesh_files/make_shape.h"

#include "geometry/decide.h"
#include "lessons/scene/file/shape_text.h"
#include "widgets/mesh_files/numbering.h"

#include <glm/common.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

namespace halfspace {
namespace {

Result<LoadedMesh> make(RawMesh raw) {
  const std::atomic<bool> cancelled = false;
  return makeShape(std::move(raw), "thing", cancelled, [](std::optional<double>) {});
}

/// What must have become of the mesh.
LoadedMesh made(RawMesh raw) {
  auto mesh = make(std::move(raw));
  EXPECT_TRUE(mesh) << mesh.problem().text();
  return mesh ? std::move(*mesh) : LoadedMesh{};
}

/// Triangles that share no corners, as of STL files.
RawMesh unshared(const std::vector<std::array<Vec3<float>, 3>> &triangles) {
  RawMesh raw;
  for (const auto &triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(raw.corners.size());
    raw.corners.insert(raw.corners.end(), triangle.begin(), triangle.end());
    raw.triangles.push_back({first, first + 1, first + 2});
  }
  return raw;
}

const Vec3<float> o(0, 0, 0);
const Vec3<float> x(4, 0, 0);
const Vec3<float> y(0, 4, 0);
const Vec3<float> z(0, 0, 4);

RawMesh randomMesh(unsigned seed, float side, std::size_t count) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<float> coordinate(-side / 2, side / 2);
  const auto corner = [&] { return Vec3<float>(coordinate(engine), coordinate(engine), coordinate(engine)); };
  std::vector<std::array<Vec3<float>, 3>> triangles;
  for (std::size_t i = 0; i < count; ++i)
    triangles.push_back({corner(), corner(), corner()});
  return unshared(triangles);
}

TEST(MakeShape, MergesEqualCornersAndMovesTheBoxOntoTheGround) {
  const LoadedMesh mesh = made(unshared({{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}}));
  ASSERT_TRUE(mesh.shape);
  EXPECT_EQ(*mesh.shape->mesh(), (TriangleMesh{{{-2, -2, 0}, {-2, 2, 0}, {2, -2, 0}, {-2, -2, 4}},
                                               {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {2, 1, 3}}}));
  EXPECT_EQ(mesh.name, "thing");
  EXPECT_EQ(mesh.triangles, 4U);
  EXPECT_EQ(mesh.size, Vec3<double>(4, 4, 4));
  EXPECT_EQ(mesh.broken + mesh.degenerate + mesh.repeated, 0U);
  const auto hit = mesh.shape->search()->search({{-1, -1, 10}, {0, 0, -1}}).nearest;
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->index, 3U);
  EXPECT_EQ(hit->t, 8);
}

TEST(MakeShape, LeavesOutBrokenTrianglesAndTheirPlaces) {
  RawMesh raw = unshared({{o, x, y}, {o, Vec3<float>(NAN, 900, 0), z}, {o, Vec3<float>(0, INFINITY, 0), z}});
  raw.triangles.push_back({0, 1, 99});
  raw.triangles.push_back({noCorner, 1, 2});
  raw.corners.emplace_back(5000, 5000, 5000); // of no triangle
  raw.triangles.push_back({0, 1, 10});
  const LoadedMesh mesh = made(std::move(raw));
  EXPECT_EQ(mesh.triangles, 1U);
  EXPECT_EQ(mesh.broken, 5U);
  EXPECT_EQ(mesh.size, Vec3<double>(4, 4, 0));
  EXPECT_EQ(mesh.shape->mesh()->corners.size(), 3U);
}

TEST(MakeShape, LeavesOutTrianglesWithoutAnArea) {
  const LoadedMesh mesh = made(unshared({{o, x, y},
                                         {o, o, y},
                                         {x, x, x},
                                         {o, x, x + x - x * 0.5F},
                                         {o, x, Vec3<float>(2, 1e-7F, 0)}})); // none once rounded
  EXPECT_EQ(mesh.triangles, 1U);
  EXPECT_EQ(mesh.degenerate, 4U);
}

TEST(MakeShape, KeepsTheFirstOfTrianglesWithTheSameCorners) {
  const LoadedMesh mesh = made(unshared({{o, x, y}, {x, y, o}, {y, x, o}, {o, x, z}, {o, x, y}}));
  EXPECT_EQ(mesh.triangles, 2U);
  EXPECT_EQ(mesh.repeated, 3U);
}

TEST(MakeShape, AMillionEqualTrianglesAreOne) {
  RawMesh raw = unshared({{o, x, y}});
  raw.triangles.resize(1'000'000, raw.triangles.front());
  const LoadedMesh mesh = made(std::move(raw));
  EXPECT_EQ(mesh.triangles, 1U);
  EXPECT_EQ(mesh.repeated, 999'999U);
}

TEST(MakeShape, AMillionTrianglesInOnePointAreAProblemThatSaysSo) {
  RawMesh raw;
  raw.corners.resize(3'000'000, x);
  for (std::uint32_t i = 0; i < 1'000'000; ++i)
    raw.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  const auto mesh = make(std::move(raw));
  ASSERT_FALSE(mesh);
  EXPECT_NE(mesh.problem().sentence.find("1000000 have no area"), std::string::npos)
      << mesh.problem().sentence;
}

TEST(MakeShape, OfNothingThatIsWholeIsAProblem) {
  const auto mesh = make({{o}, {{0, 1, 2}}});
  ASSERT_FALSE(mesh);
  EXPECT_NE(mesh.problem().sentence.find("1 have a corner that is missing"), std::string::npos)
      << mesh.problem().sentence;
  EXPECT_FALSE(make({}));
}

TEST(MakeShape, TooLongOrTooShortIsAProblem) {
  const auto sized = [](float side) {
    return make(unshared({{o, Vec3<float>(side, 0, 0), Vec3<float>(0, side, 0)}}));
  };
  EXPECT_FALSE(sized(5.1e8F));
  EXPECT_FALSE(sized(3e38F));
  EXPECT_FALSE(sized(0.9e-8F));
  EXPECT_TRUE(sized(4.9e8F));
  EXPECT_TRUE(sized(1.1e-8F));
}

TEST(MakeShape, LawOne_EveryCornerIsReadFromFilesAgain) {
  unsigned seed = 1;
  for (const float side : {1.1e-8F, 1e-3F, 1.0F, 3.3F, 4096.0F, 1e5F, 4.99e8F}) {
    const LoadedMesh mesh = made(randomMesh(seed++, side, 100));
    ASSERT_TRUE(mesh.shape);
    const WrittenShape text = written(*mesh.shape);
    const auto again = readShape(text.corners, text.faces);
    ASSERT_TRUE(again) << side << ": " << again.problem().text();
    EXPECT_EQ(**again, *mesh.shape);
  }
}

TEST(MakeShape, LawTwo_NoTrianglesAreEqualAndAllHaveAnArea) {
  // So coarse that many corners fall together.
  RawMesh raw = randomMesh(5, 8, 20'000);
  for (Vec3<float> &corner : raw.corners)
    corner = Vec3<float>(std::round(corner.x), std::round(corner.y), std::round(corner.z));
  const LoadedMesh mesh = made(raw);
  EXPECT_EQ(mesh.triangles + mesh.degenerate + mesh.repeated, raw.triangles.size());
  EXPECT_GT(mesh.degenerate, 0U);
  EXPECT_GT(mesh.repeated, 0U);
  std::set<std::array<std::uint32_t, 3>> seen;
  const TriangleMesh &found = *mesh.shape->mesh();
  for (std::size_t i = 0; i < found.triangles.size(); ++i) {
    EXPECT_EQ(decideShape(found.triangle(i)), TriangleShape::Proper);
    auto sorted = found.triangles[i];
    std::sort(sorted.begin(), sorted.end());
    EXPECT_TRUE(seen.insert(sorted).second);
  }
}

TEST(MakeShape, RoundsByLessThanAMillionthOfTheLongestSide) {
  const RawMesh raw = randomMesh(3, 100, 500);
  const LoadedMesh mesh = made(raw);
  ASSERT_EQ(mesh.triangles, 500U);
  const double step = 128 * 0x1p-20;
  Vec3<double> low(1000.0);
  Vec3<double> high(-1000.0);
  for (const Vec3<float> &corner : raw.corners) {
    low = glm::min(low, Vec3<double>(corner));
    high = glm::max(high, Vec3<double>(corner));
  }
  const Vec3<double> origin((low.x + high.x) / 2, (low.y + high.y) / 2, low.z);
  for (std::size_t i = 0; i < 1500; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      const double found = mesh.shape->mesh()->corners[i][axis];
      EXPECT_LE(std::abs(found - (static_cast<double>(raw.corners[i][axis]) - origin[axis])), step / 2);
      EXPECT_EQ(std::fmod(found, step), 0);
    }
}

TEST(MakeShape, ThatIsCancelledEndsWithAProblem) {
  const std::atomic<bool> cancelled = true;
  EXPECT_FALSE(makeShape(randomMesh(3, 1, 100), "thing", cancelled, [](std::optional<double>) {}));
}

TEST(MakeShape, ThatIsCancelledWhileItsSearchIsMadeEndsWithAProblem) {
  std::atomic<bool> cancelled = false;
  double told = 0;
  EXPECT_FALSE(makeShape(randomMesh(3, 1, 100'000), "thing", cancelled, [&](std::optional<double> part) {
    told = *part;
    cancelled = told > 0.3; // from when on only the search is missing
  }));
  EXPECT_GT(told, 0.3);
}

TEST(MakeShape, TellsHowFarItIs) {
  std::vector<double> parts;
  const std::atomic<bool> cancelled = false;
  ASSERT_TRUE(makeShape(randomMesh(3, 1, 200'000), "thing", cancelled, [&](std::optional<double> part) {
    ASSERT_TRUE(part);
    parts.push_back(*part);
  }));
  EXPECT_GT(parts.size(), 5U);
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_EQ(parts.back(), 1);
}

TEST(Numbering, CountsKeysInTheOrderInWhichTheyFirstCome) {
  Numbering<2> numbering;
  for (std::uint64_t i = 0; i < 100'000; ++i)
    ASSERT_EQ(numbering.numberOf({i % 7 == 0 ? i : i << 40U, i}),
              std::pair(static_cast<std::uint32_t>(i), true));
  for (std::uint64_t i = 0; i < 100'000; ++i)
    ASSERT_EQ(numbering.numberOf({i % 7 == 0 ? i : i << 40U, i}),
              std::pair(static_cast<std::uint32_t>(i), false));
  EXPECT_EQ(numbering.keys().size(), 100'000U);
}

} // namespace
} // namespace halfspace
