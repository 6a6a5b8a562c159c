// A ray and a box along the axes, by slabs.
#pragma once

#include "geometry/intersect_ray_solid.h"

#include <algorithm>
#include <array>

namespace halfspace {

/// How a ray's line stands to a slab, the space between two parallel planes and in them. Within and Beside:
/// it runs parallel to them, always or never in the slab.
enum class SlabCase { Crossed, Within, Beside };

/// Where a ray's line goes into a slab and comes out of it: only for Crossed, else 0.
template <class Scalar> struct SlabCrossing {
  SlabCase which = SlabCase::Within;
  Scalar in{};
  Scalar out{};
};

/// Where a ray meets a box along the axes.
template <class Scalar> struct RayBox {
  RaySolidCase which = RaySolidCase::ZeroDirection;
  SolidLocation origin = SolidLocation::Outside; ///< where the ray starts
  std::array<SlabCrossing<Scalar>, 3> slabs{};   ///< one across each axis
  /// The largest of all `in` and the smallest of all `out`; 0 for ZeroDirection and beside a slab.
  Scalar in{};
  Scalar out{};

  [[nodiscard]] bool isBeside() const {
    return std::any_of(slabs.begin(), slabs.end(),
                       [](const auto &slab) { return slab.which == SlabCase::Beside; });
  }
};

/// Intersects a ray with the box between two corners, the lowest and the highest, which may be flat. Hit: it
/// leaves the box at t ≥ 0. Behind: at t < 0. Miss: the line does not meet it. With a zero direction the case
/// says so, and only the origin's place is set.
/// (1) A point of the line is not Outside exactly where in ≤ t ≤ out for Hit and Behind, and nowhere for
///     Miss.
/// (2) For Crossed, in ≤ out, and they are the same exactly where the slab is flat.
/// (3) k·r instead of r, k ≠ 0, divides all `in` and `out` by k; for k < 0 they change places.
/// (4) A box that is not flat is met as the solid is that has its corners and faces.
template <class Scalar>
[[nodiscard]] RayBox<Scalar> intersectRayBox(const Ray<Scalar> &ray, const Vec3<Scalar> &lowest,
                                             const Vec3<Scalar> &highest) {
  RayBox<Scalar> result;
  result.origin = SolidLocation::Inside;
  for (int axis = 0; axis < 3; ++axis) {
    const Scalar &start = ray.origin[axis];
    if (start < lowest[axis] || start > highest[axis])
      result.origin = SolidLocation::Outside;
    else if (result.origin == SolidLocation::Inside && (start == lowest[axis] || start == highest[axis]))
      result.origin = SolidLocation::On;
  }
  if (isZero(ray.direction))
    return result;

  bool isFirst = true; // of the slabs that are crossed
  for (int axis = 0; axis < 3; ++axis) {
    SlabCrossing<Scalar> &slab = result.slabs.at(static_cast<std::size_t>(axis));
    const Scalar &start = ray.origin[axis];
    const Scalar &step = ray.direction[axis];
    if (step == Scalar(0)) {
      slab.which = start < lowest[axis] || start > highest[axis] ? SlabCase::Beside : SlabCase::Within;
      continue;
    }
    const Scalar low = (lowest[axis] - start) / step;
    const Scalar high = (highest[axis] - start) / step;
    slab = {SlabCase::Crossed, std::min(low, high), std::max(low, high)};
    result.in = isFirst ? slab.in : std::max(result.in, slab.in);
    result.out = isFirst ? slab.out : std::min(result.out, slab.out);
    isFirst = false;
  }
  if (result.isBeside())
    result.in = result.out = Scalar(0);
  result.which = result.isBeside() || result.in > result.out ? RaySolidCase::Miss
                 : result.out < Scalar(0)                    ? RaySolidCase::Behind
                                                             : RaySolidCase::Hit;
  return result;
}

} // namespace halfspace
