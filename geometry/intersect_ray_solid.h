// A ray and a convex solid, by Plücker products.
#pragma once

#include "geometry/intersect_ray_plane.h"
#include "geometry/place.h"
#include "geometry/solid.h"

namespace halfspace {

enum class RaySolidCase { Hit, Behind, Miss, ZeroDirection };
/// What the whole line has in common with the solid: One: it touches it in a point. Along: it lies in a face
/// or an edge. Two: it goes through.
enum class SolidContacts { None, One, Two, Along };

/// A point where a ray's line goes into or comes out of a solid.
template <class Scalar> struct SolidCrossing {
  Scalar t{};
  Vec3<Scalar> point{};
  std::size_t face = 0; ///< the lowest index of the faces there that the line goes into, or comes out of
};

/// Where a ray meets a convex solid.
template <class Scalar> struct RaySolid {
  RaySolidCase which = RaySolidCase::ZeroDirection;
  SolidContacts contacts = SolidContacts::None;
  SolidPlace origin = SolidPlace::Outside;      ///< where the ray starts
  std::optional<SolidCrossing<Scalar>> entered; ///< both are there, unless the case is Miss or ZeroDirection
  std::optional<SolidCrossing<Scalar>> left;
};

/// Whether a line crosses a face (its boundary included), by its products with all edges of the solid and the
/// sign of direction·normal ≠ 0: those with the face's own edges, as the face has them, all have that sign or
/// are 0.
template <class Scalar>
[[nodiscard]] bool crossesFace(const typename ConvexSolid<Scalar>::Face &face,
                               const std::vector<Scalar> &products, bool withNormal) {
  const Scalar zero(0);
  return std::all_of(face.sides.begin(), face.sides.end(), [&](const auto &side) {
    const Scalar &product = products[side.edge];
    return product == zero || (product > zero) == (side.forward == withNormal);
  });
}

/// Intersects a ray with a convex solid (note PL). Hit: it leaves the solid at t ≥ 0. Behind: at t < 0. Miss:
/// the line does not meet it. With a zero direction the case says so, and only the origin's place is set.
template <class Scalar>
[[nodiscard]] RaySolid<Scalar> intersectRaySolid(const Ray<Scalar> &ray, const ConvexSolid<Scalar> &solid) {
  const Scalar zero(0);
  RaySolid<Scalar> result;
  const Line<Scalar> line = lineOf(ray);
  std::vector<Scalar> products;
  products.reserve(solid.edges.size());
  for (const Line<Scalar> &edge : solid.edges)
    products.push_back(permutedInnerProduct(line, edge));

  bool inFacePlane = false;
  result.origin = SolidPlace::Inside;
  for (std::size_t i = 0; i < solid.faces.size(); ++i) {
    const auto &face = solid.faces[i];
    const Scalar f = evaluate(face.plane, ray.origin);
    if (f > zero)
      result.origin = SolidPlace::Outside;
    else if (f == zero && result.origin == SolidPlace::Inside)
      result.origin = SolidPlace::On;
    const Scalar approach = dot(ray.direction, face.plane.normal);
    if (approach == zero) {
      inFacePlane = inFacePlane || f == zero;
      continue;
    }
    auto &crossing = approach < zero ? result.entered : result.left;
    if (!crossing && crossesFace<Scalar>(face, products, approach > zero)) {
      const Scalar t = -f / approach;
      crossing = {t, pointAt(ray, t), i};
    }
  }
  if (isZero(ray.direction))
    return result;
  if (!result.entered || !result.left) {
    result.which = RaySolidCase::Miss;
    return result;
  }
  result.which = result.left->t < zero ? RaySolidCase::Behind : RaySolidCase::Hit;
  result.contacts = result.entered->t == result.left->t ? SolidContacts::One
                    : inFacePlane                       ? SolidContacts::Along
                                                        : SolidContacts::Two;
  return result;
}

} // namespace halfspace
