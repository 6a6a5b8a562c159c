// Rays.
#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// The points origin + t·direction with t ≥ 0. The direction keeps its length: t counts in multiples of it.
template <class Scalar> struct Ray {
  Vec3<Scalar> origin;
  Vec3<Scalar> direction;
};

/// origin + t·direction
template <class Scalar> [[nodiscard]] Vec3<Scalar> pointAt(const Ray<Scalar> &ray, const Scalar &t) {
  return ray.origin + ray.direction * t;
}

} // namespace halfspace
