#include "geometry/plane.h"

namespace halfspace {

std::array<Integer, 4> primitiveCoefficients(const Plane<Rational> &plane) {
  const std::array<Rational, 4> given{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
  Integer commonDenominator = 1;
  for (const Rational &coefficient : given)
    commonDenominator = mp::lcm(commonDenominator, coefficient.denominator());

  std::array<Integer, 4> integers;
  Integer commonFactor = 0;
  for (std::size_t i = 0; i < given.size(); ++i) {
    integers[i] = (given[i] * Rational(commonDenominator)).numerator();
    commonFactor = mp::gcd(commonFactor, integers[i]);
  }
  for (Integer &integer : integers)
    integer /= commonFactor;
  return integers;
}

} // namespace halfspace
