// Triangles.
#pragma once

#include "geometry/location.h"
#include "geometry/vector.h"

#include <array>

namespace halfspace {

/// Three corners; u = p1 − p0 and v = p2 − p0 span it.
template <class Scalar> struct Triangle {
  Vec3<Scalar> p0;
  Vec3<Scalar> p1;
  Vec3<Scalar> p2;
};

enum class TriangleShape { Proper, Coincident, Collinear };

/// Coincident: two corners are the same point. Collinear: u×v = 0 though no two are (note PG 6.2).
/// (1) Proper exactly where u×v ≠ 0.
/// (2) The same for the corners in any order.
template <class Scalar> [[nodiscard]] TriangleShape shapeOf(const Triangle<Scalar> &triangle) {
  const Vec3<Scalar> u = triangle.p1 - triangle.p0;
  const Vec3<Scalar> v = triangle.p2 - triangle.p0;
  if (isZero(u) || isZero(v) || triangle.p1 == triangle.p2)
    return TriangleShape::Coincident;
  return isZero(cross(u, v)) ? TriangleShape::Collinear : TriangleShape::Proper;
}

/// The point P0 + s·u + t·v of a triangle's plane (note PG 2).
/// (1) (0, 0), (1, 0) and (0, 1) give the corners.
/// (2) With the corners P1 and P2 swapped, (t, s) gives the point of (s, t).
template <class Scalar>
[[nodiscard]] Vec3<Scalar> pointOf(const Triangle<Scalar> &triangle, const Scalar &s, const Scalar &t) {
  return triangle.p0 + (triangle.p1 - triangle.p0) * s + (triangle.p2 - triangle.p0) * t;
}

/// Whether P0 + s·u + t·v lies in the parallelogram of u and v, its boundary included (note PG 2).
/// (1) So exactly where `locationInTriangle` of (s, t) or of (1 − s, 1 − t) is not Outside.
template <class Scalar> [[nodiscard]] bool isInParallelogram(const Scalar &s, const Scalar &t) {
  const Scalar zero(0);
  const Scalar one(1);
  return zero <= s && s <= one && zero <= t && t <= one;
}

/// −1, 0 or 1.
template <class Scalar> [[nodiscard]] int signOf(const Scalar &value) {
  const Scalar zero(0);
  return value < zero ? -1 : value > zero ? 1 : 0;
}

/// The location of a point by the signs of its barycentric coordinates (note PG 2; note CG). An edge's
/// feature is the index of the corner opposite. A coordinate 0 is an edge only where the other two are
/// positive, a corner where one more is 0. Requires signs that are not all 0. (1) Outside exactly where a
/// sign is −1. (2) Signs in another order give the same location, and its feature at the new index.
[[nodiscard]] inline FaceLocation locationBySigns(const std::array<int, 3> &signs) {
  int zeros = 0;
  int lastZero = -1;
  int lastPositive = -1;
  for (int i = 0; i < 3; ++i) {
    const int sign = signs[static_cast<std::size_t>(i)];
    if (sign < 0)
      return {FacePart::Outside, -1};
    if (sign == 0) {
      ++zeros;
      lastZero = i;
    } else {
      lastPositive = i;
    }
  }
  if (zeros == 0)
    return {FacePart::Interior, -1};
  return zeros == 1 ? FaceLocation{FacePart::Edge, lastZero} : FaceLocation{FacePart::Vertex, lastPositive};
}

/// The location of the point with barycentric coordinates [1 − s − t, s, t].
/// (1) Outside exactly where s < 0, t < 0 or s + t > 1.
/// (2) (t, s) gives the location of (s, t) with the features 1 and 2 swapped.
template <class Scalar> [[nodiscard]] FaceLocation locationInTriangle(const Scalar &s, const Scalar &t) {
  return locationBySigns({signOf(Scalar(Scalar(1) - s - t)), signOf(s), signOf(t)});
}

} // namespace halfspace
