// A ray and a convex polygon, by Plücker products.
#pragma once

#include "geometry/intersect_ray_plane.h"
#include "geometry/line.h"
#include "geometry/location.h"
#include "geometry/polygon.h"

#include <cassert>
#include <type_traits>

namespace halfspace {

enum class RayPolygonCase { Hit, Miss, Behind, Parallel, InPlane, ZeroDirection };

/// Where a ray meets a convex polygon, with every number on the way.
template <class Scalar> struct RayPolygon {
  RayPolygonCase which = RayPolygonCase::ZeroDirection;
  std::vector<Scalar> products; ///< with each edge i → i + 1
  FaceLocation location;        ///< edge i runs from corner i to corner i + 1
  Scalar t{};
  Vec3<Scalar> point{};

  /// Whether the ray's line crosses the polygon's plane in one point; location, t and point are set only
  /// then.
  [[nodiscard]] bool crosses() const {
    return which == RayPolygonCase::Hit || which == RayPolygonCase::Miss || which == RayPolygonCase::Behind;
  }
};

/// The location where a line crosses the plane of a convex polygon, by its products with the edges (note PL)
/// and the sign of direction·normal, where the edges go counterclockwise around the normal: inside all
/// products have that sign, on an edge its own is 0. Requires the products of a line that crosses the plane
/// in one point. (1) Negative products with the other sign, which are those of the line turned round, give
/// the same location. (2) Products that start with another edge give the same location, and its feature
/// counted from there.
template <class Scalar>
[[nodiscard]] FaceLocation locationByProducts(std::span<const Scalar> products, bool withNormal) {
  const Scalar zero(0);
  std::vector<int> zeros;
  for (std::size_t i = 0; i < products.size(); ++i) {
    if (products[i] == zero)
      zeros.push_back(static_cast<int>(i));
    else if ((products[i] > zero) != withNormal)
      return {};
  }
  if (zeros.empty())
    return {FacePart::Interior, -1};
  if (zeros.size() == 1)
    return {FacePart::Edge, zeros.front()};
  // Two neighbours meet in the corner where the second one starts; the last edge and the first one in corner
  // 0.
  const bool aroundTheEnd = zeros[1] != zeros[0] + 1;
  return {FacePart::Vertex, aroundTheEnd ? 0 : zeros[1]};
}

/// The products of a line with each edge i → i + 1 of a polygon (note PL), whatever its shape.
template <class Scalar>
[[nodiscard]] std::vector<Scalar> productsWithEdges(const Line<Scalar> &line,
                                                    std::span<const Vec3<Scalar>> corners) {
  std::vector<Scalar> products;
  products.reserve(corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i)
    products.push_back(
        permutedInnerProduct(line, lineThrough(corners[i], corners[(i + 1) % corners.size()])));
  return products;
}

/// Intersects a ray with a convex polygon (note PL). Hit: t ≥ 0 inside or on the boundary. Miss: the line
/// crosses the plane outside. Behind: it crosses the polygon at t < 0. With a zero direction the case says
/// so. Requires a polygon whose shape is Convex.
/// (1) The product with the edge from A to B is r·((A − Q)×(B − Q)), and all together are r·(twice the area
///     vector).
/// (2) The point is Q + t·r and lies in the plane.
/// (3) Of a triangle case, t and point are those of `intersectRayTriangle`; its edge i is edge i + 1 here, or
///     0 for i = 2.
/// (4) The corners the other way round give the same case, t and point, and the negative products in
///     the opposite order.
template <class Scalar>
[[nodiscard]] RayPolygon<Scalar> intersectRayPolygon(const Ray<Scalar> &ray,
                                                     std::span<const Vec3<Scalar>> corners) {
  if constexpr (std::is_same_v<Scalar, Rational>) // rounded corners hardly ever lie in one plane exactly
    assert(shapeOf(Polygon<Scalar>(corners.begin(), corners.end())) == PolygonShape::Convex);
  const Scalar zero(0);
  RayPolygon<Scalar> result;
  result.products = productsWithEdges(lineOf(ray), corners);

  const RayPlane<Scalar> plane = intersectRayPlane(ray, planeThrough(corners[0], corners[1], corners[2]));
  if (!plane.crosses()) {
    result.which = isZero(ray.direction)                  ? RayPolygonCase::ZeroDirection
                   : plane.which == RayPlaneCase::InPlane ? RayPolygonCase::InPlane
                                                          : RayPolygonCase::Parallel;
    return result;
  }
  result.t = plane.t;
  result.point = plane.point;
  result.location = locationByProducts(std::span<const Scalar>(result.products), plane.denominator > zero);
  result.which = result.location.part == FacePart::Outside ? RayPolygonCase::Miss
                 : plane.which == RayPlaneCase::Behind     ? RayPolygonCase::Behind
                                                           : RayPolygonCase::Hit;
  return result;
}

} // namespace halfspace
