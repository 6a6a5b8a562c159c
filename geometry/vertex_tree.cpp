#include "geometry/vertex_tree.h"

namespace halfspace {

int binaryExponent(const Rational &p, const Rational &q) {
  const auto bits = [](const Rational &whole) {
    return static_cast<int>(mp::msb(Integer(mp::abs(whole.numerator()))));
  };
  return bits(p) - bits(q);
}

double nearestQuotient(const Rational &p, const Rational &q, int exponent) {
  return nearestDouble(p.numerator(), q.numerator(), exponent);
}

} // namespace halfspace
