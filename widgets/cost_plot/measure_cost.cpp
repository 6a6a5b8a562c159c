#include "widgets/cost_plot/measure_cost.h"

#include "geometry/decide.h"
#include "geometry/search/hit_finder.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace halfspace {
namespace {

using Clock = std::chrono::steady_clock;
using Microseconds = std::chrono::duration<double, std::micro>;

constexpr std::array<std::size_t, 5> sizes{fewestMeasured, 1000, 10'000, 100'000, mostMeasured};
/// Searches are repeated for so long, and at least so often.
constexpr Microseconds longEnough(5000);
constexpr int fewestSearches = 3;

constexpr double fieldWidth = 64;
/// The height of a bump above and below z = 0, as part of a cell's width.
constexpr double bumpHeight = 0.125;
/// Numbers of a shot beyond this become it: doubles have room for what is calculated with them.
constexpr double largestNumber = 1e100;

/// Cells side by side, two triangles each; the last ones may be missing.
struct Grid {
  explicit Grid(std::size_t triangles)
      : columns(static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(triangles) / 2)))),
        rows(static_cast<std::uint32_t>((triangles + 2 * columns - 1) / (2 * columns))) {}

  [[nodiscard]] std::uint32_t corner(std::uint32_t column, std::uint32_t row) const {
    return row * (columns + 1) + column;
  }

  std::uint32_t columns;
  std::uint32_t rows;
};

void addCorners(TriangleMesh &mesh, const Grid &grid) {
  const double cell = fieldWidth / grid.columns;
  std::minstd_rand random(7);
  for (std::uint32_t row = 0; row <= grid.rows; ++row)
    for (std::uint32_t column = 0; column <= grid.columns; ++column) {
      const double part = static_cast<double>(random()) / static_cast<double>(std::minstd_rand::max());
      mesh.corners.emplace_back(cell * (column - grid.columns / 2.0), cell * (row - grid.rows / 2.0),
                                cell * bumpHeight * (2 * part - 1));
    }
}

void addTriangles(TriangleMesh &mesh, const Grid &grid) {
  for (std::uint32_t row = 0; row < grid.rows; ++row)
    for (std::uint32_t column = 0; column < grid.columns; ++column) {
      const std::uint32_t first = grid.corner(column, row);
      const std::uint32_t opposite = grid.corner(column + 1, row + 1);
      mesh.triangles.push_back({first, grid.corner(column + 1, row), opposite});
      mesh.triangles.push_back({first, opposite, grid.corner(column, row + 1)});
    }
}

double inBounds(const Rational &number) {
  return std::clamp(toDouble(number), -largestNumber, largestNumber);
}

/// Where the centre of the field is to be.
Vec3<Rational> targetOf(const Ray<Rational> &ray) {
  const Rational &height = ray.origin.z;
  const bool comesDown = height > 0 && ray.direction.z < 0;
  const Vec3<Rational> way =
      comesDown ? ray.direction * (height / -ray.direction.z) : Vec3<Rational>{0, 0, -height};
  return ray.origin + way;
}

/// A ray in doubles that hits where this one does, up to their precision.
Ray<Rational> roundedShot(const Vec3<Rational> &origin, const Vec3<Rational> &direction) {
  Rational longest = 0;
  for (int axis = 0; axis < 3; ++axis)
    longest = std::max({longest, direction[axis], -direction[axis]});
  assert(longest > 0);
  Ray<double> rounded;
  for (int axis = 0; axis < 3; ++axis) {
    rounded.origin[axis] = inBounds(origin[axis]);
    rounded.direction[axis] = toDouble(direction[axis] / longest);
  }
  return exactly(rounded);
}

std::size_t triangleCount(const std::vector<MeshObject> &meshes) {
  return std::accumulate(
      meshes.begin(), meshes.end(), std::size_t(0),
      [](std::size_t count, const MeshObject &mesh) { return count + mesh.shape->triangleCount(); });
}

/// The best time of one search.
Microseconds timeOf(const HitSearch &search, const Ray<Rational> &ray, const std::atomic<bool> &cancelled) {
  Microseconds best(std::numeric_limits<double>::infinity());
  const Clock::time_point begin = Clock::now();
  for (int i = 0; !cancelled && (i < fewestSearches || Clock::now() - begin < longEnough); ++i) {
    const Clock::time_point before = Clock::now();
    (void)search.search(ray);
    best = std::min<Microseconds>(best, Clock::now() - before);
  }
  return best;
}

CostPoint measured(const Ray<Rational> &shot, const TriangleMesh &target,
                   const std::atomic<bool> &cancelled) {
  const PlainHitSearch plain(target);
  const HitFinder tree(trianglesOf(target));
  const SearchResult ofPlain = plain.search(shot);
  const SearchResult ofTree = tree.search(shot);
  assert(ofPlain.nearest == ofTree.nearest);
  return {target.triangles.size(), ofPlain.cost, ofTree.cost, timeOf(plain, shot, cancelled).count(),
          timeOf(tree, shot, cancelled).count()};
}

} // namespace

bool Aim::operator==(const Aim &other) const {
  return ray.origin == other.ray.origin && ray.direction == other.ray.direction && meshes == other.meshes;
}

TriangleMesh bumpyField(std::size_t triangles) {
  const Grid grid(triangles);
  TriangleMesh mesh;
  addCorners(mesh, grid);
  addTriangles(mesh, grid);
  mesh.triangles.resize(triangles);
  return mesh;
}

Ray<Rational> shotAtField(const Ray<Rational> &ray) {
  return roundedShot(ray.origin - targetOf(ray), ray.direction);
}

TriangleMesh oneMeshOf(const std::vector<MeshObject> &meshes) {
  TriangleMesh all;
  for (const MeshObject &mesh : meshes) {
    const auto first = static_cast<std::uint32_t>(all.corners.size());
    const glm::dmat3 axes = MeshPlacement(mesh).axes();
    const Vec3<double> place = toDouble(mesh.place);
    for (const Vec3<double> &corner : mesh.shape->mesh()->corners)
      all.corners.push_back(axes * corner + place);
    for (const auto &[a, b, c] : mesh.shape->mesh()->triangles)
      all.triangles.push_back({first + a, first + b, first + c});
  }
  return all;
}

void measureCost(const Aim &aim, const std::atomic<bool> &cancelled, const TellCost &tell, std::size_t most) {
  const auto measure = [&](const Ray<Rational> &shot, const TriangleMesh &target, bool inScene) {
    CostPoint point = measured(shot, target, cancelled);
    point.inScene = inScene;
    if (!cancelled)
      tell(point);
  };
  if (const std::size_t count = triangleCount(aim.meshes); count > 0 && count <= most)
    measure(roundedShot(aim.ray.origin, aim.ray.direction), oneMeshOf(aim.meshes), true);
  for (const std::size_t triangles : sizes)
    if (!cancelled && triangles <= most)
      measure(shotAtField(aim.ray), bumpyField(triangles), false);
}

} // namespace halfspace
