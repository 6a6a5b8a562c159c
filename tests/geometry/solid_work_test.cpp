// How much work it is to judge a solid: counted, not timed.
#include "geometry/solid_shape.h"

#include <gtest/gtest.h>

#include <map>

namespace halfspace {
namespace {

/// A number that counts how often two of its kind are multiplied or compared.
struct Counted {
  Counted() = default;
  Counted(int whole) : value(whole) {} // NOLINT(google-explicit-constructor): as a fraction is made of one
  explicit Counted(Rational given) : value(std::move(given)) {}

  Counted operator-() const { return Counted(-value); }
  Counted &operator+=(const Counted &other) { return *this = *this + other; }
  Counted &operator-=(const Counted &other) { return *this = *this - other; }
  Counted &operator*=(const Counted &other) { return *this = *this * other; }
  friend Counted operator+(const Counted &a, const Counted &b) { return Counted(a.value + b.value); }
  friend Counted operator-(const Counted &a, const Counted &b) { return Counted(a.value - b.value); }
  friend Counted operator*(const Counted &a, const Counted &b) {
    ++work;
    return Counted(a.value * b.value);
  }
  friend bool operator==(const Counted &a, const Counted &b) {
    ++work;
    return a.value == b.value;
  }
  friend auto operator<=>(const Counted &a, const Counted &b) {
    ++work;
    return a.value <=> b.value;
  }

  Rational value;
  static inline long work = 0;
};

double toDouble(const Counted &number) { return toDouble(number.value); }

using CountedMesh = SolidMesh<Counted>;

/// Slanted against all axes, so that boxes along them stand far off the faces.
Vec3<Counted> slanted(int x, int y, int z) {
  return {Counted(x + y + 3 * z), Counted(2 * y - x + z), Counted(5 * z - y)};
}

/// Over so many corners of a parabola.
CountedMesh prism(int sides) {
  CountedMesh mesh;
  for (const int z : {0, 1})
    for (int x = 0; x < sides; ++x)
      mesh.vertices.push_back(slanted(x, x * x, z));
  const auto count = static_cast<std::uint32_t>(sides);
  mesh.faces.resize(2);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t next = (i + 1) % count;
    mesh.faces[0].push_back(count - 1 - i);
    mesh.faces[1].push_back(count + i);
    mesh.faces.push_back({i, next, count + next, count + i});
  }
  return mesh;
}

/// A cube whose six faces are divided into so many squares each way.
CountedMesh dividedCube(int squares) {
  CountedMesh mesh;
  std::map<std::array<int, 3>, std::uint32_t> indices;
  const auto vertex = [&](int axis, int level, int a, int b) {
    std::array<int, 3> at{};
    at[static_cast<std::size_t>(axis)] = level;
    at[static_cast<std::size_t>((axis + 1) % 3)] = a;
    at[static_cast<std::size_t>((axis + 2) % 3)] = b;
    const auto [place, isNew] = indices.emplace(at, static_cast<std::uint32_t>(mesh.vertices.size()));
    if (isNew)
      mesh.vertices.push_back(slanted(at[0], at[1], at[2]));
    return place->second;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (const int level : {0, squares})
      for (int a = 0; a < squares; ++a)
        for (int b = 0; b < squares; ++b) {
          auto &face = mesh.faces.emplace_back();
          for (const auto &[i, j] : {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)})
            face.push_back(vertex(axis, level, a + i, b + j));
          if (level == 0)
            std::reverse(face.begin(), face.end());
        }
  return mesh;
}

/// Multiplications and comparisons for each corner of a face.
double workPerCorner(const CountedMesh &mesh, SolidShape expected) {
  std::size_t corners = 0;
  for (const auto &face : mesh.faces)
    corners += face.size();
  Counted::work = 0;
  EXPECT_EQ(shapeOf(mesh), expected);
  return static_cast<double>(Counted::work) / static_cast<double>(corners);
}

/// Of four times as many faces each corner may be so much more work: more than the doubles' share in it
/// grows, and far less than where all vertices are held against all faces.
constexpr double growth = 1.2;

TEST(SolidWork, PrismOfFourTimesTheSides_IsFourTimesTheWork) {
  EXPECT_LT(workPerCorner(prism(800), SolidShape::Convex),
            growth * workPerCorner(prism(200), SolidShape::Convex));
}

TEST(SolidWork, FacesInOnePlane_AreNotHeldAgainstEachOthersVertices) {
  EXPECT_LT(workPerCorner(dividedCube(20), SolidShape::Convex),
            growth * workPerCorner(dividedCube(10), SolidShape::Convex));
}

TEST(SolidWork, OpenSolids_AreNoMoreWorkToRefuse) {
  const auto opened = [](CountedMesh mesh) {
    mesh.faces.pop_back();
    return workPerCorner(mesh, SolidShape::NotClosed);
  };
  EXPECT_LT(opened(prism(800)), growth * opened(prism(200)));
  EXPECT_LT(opened(dividedCube(20)), growth * opened(dividedCube(10)));
}

TEST(SolidWork, VerticesOfNoFace_AreNoMoreWork) {
  const auto withLoose = [](int sides) {
    CountedMesh mesh = prism(sides);
    for (int x = 1; x + 1 < sides; ++x)
      mesh.vertices.push_back(slanted(x, x * x + 1, 1));
    return workPerCorner(mesh, SolidShape::Convex);
  };
  EXPECT_LT(withLoose(800), growth * withLoose(200));
}

} // namespace
} // namespace halfspace
