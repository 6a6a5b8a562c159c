// What the recomputations about torpedoes share: meshes in the scene, and the saucer's shots.
#pragma once

#include "geometry/ray.h"
#include "geometry/triangle.h"
#include "lessons/object/kinds/mesh.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

#include <random>

namespace halfspace::test {

/// Cosine and sine.
using CosineAndSine = std::pair<Rational, Rational>;

/// The whole number below; of a whole number itself.
inline Rational wholeBelow(const Rational &x) {
  Rational whole = roundToMultiple(x, 1);
  while (whole > x)
    whole -= 1;
  return whole;
}

/// The largest number from 0 to `most` for which it holds. It must hold for 0, and for all before one for
/// which it does.
template <class Holds> int largest(int most, Holds holds) {
  int low = 0;
  while (low < most) {
    const int middle = low + (most - low + 1) / 2;
    if (holds(Rational(middle)))
      low = middle;
    else
      most = middle - 1;
  }
  return low;
}

/// The fraction whose square it is, if there is one: Newton's way from above, in whole numbers.
inline std::optional<Rational> rootOf(const Rational &square) {
  const Rational whole = square.numerator() * square.denominator();
  Rational root = whole + 1;
  while (root * root > whole)
    root = wholeBelow((root + wholeBelow(whole / root)) / 2);
  if (root * root != whole)
    return {};
  return root / square.denominator();
}

/// Of the angle from the x-axis to (x, y). Where the length is no fraction, the tangent of its half is the
/// two-hundredth nearest to the one that solves y·t² + 2x·t = y.
inline CosineAndSine turnOf(const Rational &x, const Rational &y) {
  if (x == 0 && y == 0)
    return {1, 0};
  if (const auto length = rootOf(x * x + y * y))
    return {x / *length, y / *length};
  const Rational ahead = abs(x);
  const Rational aside = abs(y);
  const auto isBelow = [&](const Rational &steps) {
    const Rational t = (2 * steps - 1) / 400;
    return steps == 0 || aside * t * t + 2 * ahead * t < aside;
  };
  const Rational t = Rational(largest(200, isBelow), 200);
  const Rational cosine = 2 / (1 + t * t) - 1;
  const Rational sine = t + t * cosine;
  return {x < 0 ? Rational(-cosine) : cosine, y < 0 ? Rational(-sine) : sine};
}

/// The triangles of a mesh where they stand in the scene.
inline std::vector<Triangle<Rational>> trianglesOf(const MeshObject &mesh) {
  const auto [cosine, sine] = turnOf(mesh.heading.x, mesh.heading.y);
  const ExactVec3 alongX(cosine, sine, 0);
  const ExactVec3 alongY(-sine, cosine, 0);
  const auto placed = [&](const Vec3<double> &corner) {
    const ExactVec3 turned = alongX * exactly(corner.x) + alongY * exactly(corner.y);
    return mesh.place + ExactVec3(turned.x, turned.y, exactly(corner.z)) * mesh.scale;
  };
  std::vector<Triangle<Rational>> triangles;
  const TriangleMesh &own = *mesh.shape->mesh();
  for (const auto &[a, b, c] : own.triangles)
    triangles.push_back({placed(own.corners[a]), placed(own.corners[b]), placed(own.corners[c])});
  return triangles;
}

/// How a ray Q + λr meets a triangle P0 + su + tv, by Cramer's rule.
struct Met {
  std::string caseName;
  std::optional<Rational> lambda; ///< where its line crosses the triangle's plane
};

inline Met meet(const Ray<Rational> &ray, const Triangle<Rational> &triangle) {
  const ExactVec3 u = triangle.p1 - triangle.p0;
  const ExactVec3 v = triangle.p2 - triangle.p0;
  const ExactVec3 back = -ray.direction;
  const ExactVec3 w = ray.origin - triangle.p0;
  if (vanishes(perpendicular(u, v)))
    return {vanishes(u) || vanishes(v) || u == v ? "coincident" : "collinear", {}};
  const Rational whole = determinant(u, v, back);
  if (whole == 0)
    return {determinant(u, v, w) == 0 ? "in-plane" : "parallel", {}};
  const Rational s = determinant(w, v, back) / whole;
  const Rational t = determinant(u, w, back) / whole;
  const Rational lambda = determinant(u, v, w) / whole;
  const bool isInside = s >= 0 && t >= 0 && s + t <= 1;
  return {!isInside ? "miss" : lambda < 0 ? "behind" : "hit", lambda};
}

/// What the saucer fires last before a frame.
struct LastShot {
  Rational number;
  Rational frame;
  ExactVec3 barrel;
};

inline LastShot lastShot(const Rational &frame, const Rational &seed, const ExactVec3 &barrel) {
  constexpr int framesPerShot = 150;
  if (seed == 0)
    return {0, 0, barrel};
  const Rational number = wholeBelow(frame / framesPerShot);
  const auto word = [](const Rational &x) {
    return static_cast<std::uint32_t>(toDouble(wholeBelow(abs(x))));
  };
  std::seed_seq both{word(seed), word(number)};
  std::mt19937 first(both);
  std::mt19937 second(both);
  second.discard(1);
  return {number, number * framesPerShot, {int(first() % 13) - 6, int(second() % 13) - 6, -8}};
}

} // namespace halfspace::test
