// A ray as VTK asks for it.
#pragma once

#include "geometry/ray.h"

namespace halfspace::bench {

/// A segment along the ray, longer than any scene here, and the places that VTK writes its answer to.
struct VtkSegment {
  explicit VtkSegment(const Ray<double> &ray) : origin(ray.origin), end(pointAt(ray, length)) {}

  static constexpr double length = 100; ///< in multiples of the ray's direction

  Vec3<double> origin;
  Vec3<double> end;
  Vec3<double> point{};
  Vec3<double> parametric{};
  double t = 0; ///< from 0 to 1 along the segment
  int part = 0;
};

} // namespace halfspace::bench
