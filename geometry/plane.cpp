#include "geometry/plane.h"

#include "geometry/integer.h"

#include <cassert>

namespace halfspace {

std::array<Rational, 4> primitiveCoefficients(const Plane<Rational> &plane) {
  assert(!isZero(plane.normal));
  std::array<Rational, 4> coefficients{plane.normal.x, plane.normal.y, plane.normal.z, plane.offset};
  // The greatest number of which all of them are whole multiples.
  Integer commonFactor = 0;
  Integer commonDenominator = 1;
  for (const Rational &each : coefficients) {
    commonFactor = mp::gcd(commonFactor, numeratorOf(each));
    commonDenominator = mp::lcm(commonDenominator, denominatorOf(each));
  }
  const Rational unit = rationalOf(commonFactor) / rationalOf(commonDenominator);
  for (Rational &each : coefficients)
    each /= unit;
  return coefficients;
}

} // namespace halfspace
