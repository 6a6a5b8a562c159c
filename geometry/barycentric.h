// A point by its weights at the corners of a triangle.
#pragma once

#include "geometry/surd.h"
#include "geometry/triangle.h"

namespace halfspace {

enum class BarycentricCase { InPlane, OffPlane, Coincident, Collinear };

/// A point of a triangle's plane as ρ·P0 + σ·P1 + τ·P2 (note CG). The arrays go by the corners.
template <class Scalar> struct Barycentric {
  BarycentricCase which = BarycentricCase::Coincident;
  Vec3<Scalar> normal{}; ///< u×v, as long as twice the triangle's area
  Root<Scalar> area{};   ///< of the triangle
  /// Perpendicular to the small triangles of the point and the edge opposite to each corner, as long as twice
  /// their areas.
  std::array<Vec3<Scalar>, 3> normals{};
  std::array<Scalar, 3> weights{};     ///< ρ, σ, τ; set only for InPlane
  std::array<Root<Scalar>, 3> areas{}; ///< of the small triangles: negative beyond the edge; likewise
  FaceLocation location;               ///< likewise
};

/// Weighs the corners of a triangle for a point. A degenerate triangle is named by its shape; the normals and
/// the area are set in all cases. In the plane:
/// (1) ρ + σ + τ = 1, and ρ·P0 + σ·P1 + τ·P2 is the point.
/// (2) Each of the normals is its weight times u×v, and each of the areas its weight times the area.
/// (3) The point P0 + s·u + t·v has the weights 1 − s − t, s and t.
/// (4) Corners in another order have the same weights.
/// (5) A way parallel to an edge keeps the weight of the corner opposite.
template <class Scalar>
[[nodiscard]] Barycentric<Scalar> barycentricOf(const Vec3<Scalar> &point, const Triangle<Scalar> &triangle) {
  Barycentric<Scalar> result;
  const std::array toCorners{Vec3<Scalar>(triangle.p0 - point), Vec3<Scalar>(triangle.p1 - point),
                             Vec3<Scalar>(triangle.p2 - point)};
  const Vec3<Scalar> &normal = result.normal =
      cross(Vec3<Scalar>(triangle.p1 - triangle.p0), Vec3<Scalar>(triangle.p2 - triangle.p0));
  const Scalar square = dot(normal, normal);
  result.area = timesRoot(Scalar(Scalar(1) / Scalar(2)), square);
  for (std::size_t i = 0; i < 3; ++i)
    result.normals[i] = cross(toCorners[(i + 1) % 3], toCorners[(i + 2) % 3]);
  const TriangleShape shape = shapeOf(triangle);
  if (shape != TriangleShape::Proper) {
    result.which =
        shape == TriangleShape::Coincident ? BarycentricCase::Coincident : BarycentricCase::Collinear;
    return result;
  }
  const Scalar zero(0);
  if (dot(toCorners[0], normal) != zero) {
    result.which = BarycentricCase::OffPlane;
    return result;
  }
  result.which = BarycentricCase::InPlane;
  for (std::size_t i = 0; i < 3; ++i) {
    result.weights[i] = dot(result.normals[i], normal) / square;
    result.areas[i] = result.area * result.weights[i];
  }
  result.location = locationInTriangle(result.weights[1], result.weights[2]);
  return result;
}

} // namespace halfspace
