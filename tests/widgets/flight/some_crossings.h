// Crossings of a ray with a few fragments.
#pragma once

#include "lessons/construction/crossings.h"

#include <QString>

namespace halfspace::test {

inline Crossing crossingAt(std::size_t number, RayTriangleCase which, const Rational &t) {
  return {number, "barn " + std::to_string(number), which,
          Crossing::Parameters{t, Rational(1, 4), Rational(3, 8)}};
}

/// By t: 4 behind, 3 is hit first, 5 and 1 later at the same place, 6 beside, 2 parallel.
inline Crossings someCrossings() {
  using enum RayTriangleCase;
  Crossings crossings;
  crossings.all = {crossingAt(4, Behind, Rational(-1, 4)), crossingAt(3, Hit, Rational(1, 2)),
                   crossingAt(1, Hit, Rational(5, 4)),     crossingAt(5, Hit, Rational(5, 4)),
                   crossingAt(6, Miss, Rational(7, 4)),    {2, "barn 2", Parallel, {}}};
  crossings.fragments = 6;
  crossings.nearest = 3;
  return crossings;
}

} // namespace halfspace::test
