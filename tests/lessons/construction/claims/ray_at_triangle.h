// A triangle and a ray, as several constructions look at them.
#pragma once

#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/claims/triangle_words.h"

namespace halfspace::test {

struct RayAtTriangle : TriangleCorners {
  RayAtTriangle(const std::array<ExactVec3, 3> &triangle, const RayObject &ray)
      : TriangleCorners(triangle), L(ray), rn(product(L.direction, n)),
        height(product(n, L.origin) - product(n, corners[0])) {}

  /// A triangle, the first object, and a ray, the second.
  explicit RayAtTriangle(Objects objects)
      : RayAtTriangle(TriangleCorners(objects).corners, objectAs<RayObject>(*objects[1]).value()) {}

  bool isRay() const { return !vanishes(L.direction); }
  bool crosses() const { return isTriangle() && rn != 0; }
  bool isParallel() const { return isTriangle() && isRay() && rn == 0 && height != 0; }
  bool isInPlane() const { return isTriangle() && isRay() && rn == 0 && height == 0; }

  /// Of the ray, where its line crosses the triangle's plane.
  Rational lambda() const { return -height / rn; }

  /// The corners' weights there: the volumes that the direction spans with the edges, as shares.
  std::array<Rational, 3> weights() const {
    std::array<Rational, 3> volumes;
    for (std::size_t i = 0; i < 3; ++i)
      volumes.at(i) = determinant(L.direction, ExactVec3(corners.at((i + 1) % 3) - L.origin),
                                  ExactVec3(corners.at((i + 2) % 3) - L.origin));
    const Rational whole = volumes[0] + volumes[1] + volumes[2];
    for (Rational &volume : volumes)
      volume /= whole;
    return volumes;
  }

  bool hits() const { return crosses() && !isOutside(weights()) && lambda() >= 0; }
  bool isBehind() const { return crosses() && !isOutside(weights()) && lambda() < 0; }
  bool misses() const { return crosses() && isOutside(weights()); }

  RayObject L;
  Rational rn;
  Rational height; ///< of the ray's start over the plane, times |n|
};

/// Of the case of a hit.
[[nodiscard]] inline Claims hitClaims() {
  return placeClaims<RayAtTriangle>(
      [](const RayAtTriangle &at) { return at.hits(); }, "The ray hits inside the triangle, at {lambda}.",
      "The ray hits on the edge {edge}, at {lambda}.", "The ray hits at the corner {corner}, at {lambda}.");
}

} // namespace halfspace::test
