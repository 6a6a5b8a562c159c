// Spheres.
#pragma once

#include "geometry/vector.h"

namespace halfspace {

/// The points at distance radius > 0 from the center.
template <class Scalar> struct Sphere {
  Vec3<Scalar> center;
  Scalar radius;
};

} // namespace halfspace
