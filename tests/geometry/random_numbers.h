// Seeded random numbers and exact helpers for the tests of geometry.
#pragma once

#include "geometry/triangle.h"
#include "geometry/vector.h"

#include <cmath>
#include <random>

namespace halfspace {

using ExactVec3 = Vec3<Rational>;

/// Always the same sequence for the same seed.
class RandomNumbers {
public:
  explicit RandomNumbers(std::uint64_t seed) : m_engine(seed) {}

  /// Between low and high, both possible.
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(m_engine); }

  /// A fraction within ±limit with a denominator of at most 12.
  Rational rational(int limit = 20) {
    const int denominator = integer(1, 12);
    return Rational(integer(-limit * denominator, limit * denominator)) / denominator;
  }

  Rational nonZeroRational(int limit = 20) {
    for (;;)
      if (Rational value = rational(limit); value != 0)
        return value;
  }

  ExactVec3 vector(int limit = 20) { return {rational(limit), rational(limit), rational(limit)}; }

  ExactVec3 nonZeroVector(int limit = 20) {
    for (;;)
      if (ExactVec3 value = vector(limit); !isZero(value))
        return value;
  }

  /// With integer coordinates: small ones keep the products of a sweep quick, and meet in special positions
  /// often.
  ExactVec3 wholeVector(int limit) {
    return {integer(-limit, limit), integer(-limit, limit), integer(-limit, limit)};
  }

  ExactVec3 nonZeroWholeVector(int limit) {
    for (;;)
      if (ExactVec3 value = wholeVector(limit); !isZero(value))
        return value;
  }

  Triangle<Rational> properTriangle() {
    for (;;) {
      Triangle<Rational> triangle{vector(), vector(), vector()};
      if (shapeOf(triangle) == TriangleShape::Proper)
        return triangle;
    }
  }

  /// Any finite double but zero: every exponent is as likely as any other.
  double anyDouble() {
    const double mantissa = std::uniform_real_distribution<double>(1, 2)(m_engine);
    const double value = std::ldexp(mantissa, integer(-1074, 1023));
    return integer(0, 1) == 0 ? value : -value;
  }

private:
  std::mt19937_64 m_engine;
};

} // namespace halfspace
