// A ray over fractions as doubles see it.
#pragma once

#include "geometry/ray.h"

namespace halfspace {

/// The nearest ray in doubles, beside the ray itself, which must outlive it.
struct RoundedRay {
  explicit RoundedRay(const Ray<Rational> &given);

  const Ray<Rational> &exact;
  Ray<double> rounded; ///< infinite where a number is beyond the range of doubles
  bool isExact;        ///< both are the same
};

} // namespace halfspace
