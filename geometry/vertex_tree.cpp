#include "geometry/vertex_tree.h"

#include "geometry/integer.h"

namespace halfspace {

int binaryExponent(const Rational &p, const Rational &q) {
  const auto bits = [](const Rational &whole) {
    return static_cast<int>(mp::msb(Integer(mp::abs(integerOf(whole)))));
  };
  return bits(p) - bits(q);
}

double nearestQuotient(const Rational &p, const Rational &q, int exponent) {
  return nearestDouble(integerOf(p), integerOf(q), exponent);
}

} // namespace halfspace
