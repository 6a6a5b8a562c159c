// Fractions as the shortest integers in the same proportion.
#pragma once

#include "geometry/rational.h"

#include <array>
#include <cassert>

namespace halfspace {

/// The positive multiple of the fractions in integers without a common factor. Requires one that is not 0.
/// (1) They are in the proportion of the fractions, with the same signs.
/// (2) Their greatest common divisor is 1.
/// (3) The same for k times the fractions with k > 0, the negatives for k < 0.
template <std::size_t size>
[[nodiscard]] std::array<Integer, size> primitiveIntegers(const std::array<Rational, size> &given) {
  Integer commonDenominator = 1;
  for (const Rational &each : given)
    commonDenominator = mp::lcm(commonDenominator, each.denominator());

  std::array<Integer, size> integers;
  Integer commonFactor = 0;
  for (std::size_t i = 0; i < size; ++i) {
    integers[i] = (given[i] * Rational(commonDenominator)).numerator();
    commonFactor = mp::gcd(commonFactor, integers[i]);
  }
  assert(commonFactor != 0);
  for (Integer &integer : integers)
    integer /= commonFactor;
  return integers;
}

} // namespace halfspace
