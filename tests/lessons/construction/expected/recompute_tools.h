// What recomputations share: formulas written otherwise than the program's.
#pragma once

#include "tests/lessons/construction/expected/expected.h"

#include "lessons/object/kinds/plane.h"

#include <algorithm>
#include <array>

namespace halfspace::test {

inline Rational product(const ExactVec3 &a, const ExactVec3 &b) {
  Rational sum = 0;
  for (int i = 0; i < 3; ++i)
    sum += a[i] * b[i];
  return sum;
}

inline ExactVec3 perpendicular(const ExactVec3 &a, const ExactVec3 &b) {
  ExactVec3 result;
  for (int i = 0; i < 3; ++i)
    result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
  return result;
}

/// Of the matrix with these columns.
inline Rational determinant(const ExactVec3 &a, const ExactVec3 &b, const ExactVec3 &c) {
  return a.x * (b.y * c.z - b.z * c.y) - b.x * (a.y * c.z - a.z * c.y) + c.x * (a.y * b.z - a.z * b.y);
}

inline bool vanishes(const ExactVec3 &v) { return product(v, v) == 0; }

inline SignedSquares numbers(const ExactVec3 &v) {
  return {signedSquare(v.x), signedSquare(v.y), signedSquare(v.z)};
}
inline SignedSquares number(const Rational &x) { return {signedSquare(x)}; }

/// Divided by |n|.
inline SignedSquares normalizedNumbers(const ExactVec3 &v, const Rational &normalSquared) {
  return {signedSquare(v.x, normalSquared), signedSquare(v.y, normalSquared),
          signedSquare(v.z, normalSquared)};
}

/// Of two whole numbers ≥ 0 (Euclid, Elements VII.2).
inline Rational commonFactor(Rational a, Rational b) {
  while (b != 0) {
    const Rational times = roundToMultiple(a / b, 1);
    a = std::exchange(b, abs(a - times * b));
  }
  return a;
}

/// The shortest positive multiple in integers: times the common denominator, by the common factor.
inline SignedSquares primitiveOf(const std::array<Rational, 4> &coefficients) {
  Rational multiple = 1;
  for (const Rational &each : coefficients)
    multiple *= each.denominator();
  Rational factor = 0;
  for (const Rational &each : coefficients)
    factor = commonFactor(factor, abs(each * multiple));
  SignedSquares result;
  for (const Rational &each : coefficients)
    result.push_back(signedSquare(Rational(each * multiple / factor)));
  return result;
}

/// The foot of a point: its multiplier k solves n·(x − k·n − P0) = 0.
inline ExactVec3 footOf(const ExactVec3 &x, const PlaneObject &plane) {
  const Rational k = product(plane.normal, ExactVec3(x - plane.point)) / product(plane.normal, plane.normal);
  ExactVec3 foot;
  for (int i = 0; i < 3; ++i)
    foot[i] = x[i] - k * plane.normal[i];
  return foot;
}

inline Names coordinatesAt(const ExactVec3 &at) {
  return {{"x", quantity(at.x)}, {"y", quantity(at.y)}, {"z", quantity(at.z)}, {"P", quantity(at)}};
}

/// Places without a pattern, off every plane that the tests make.
inline const ExactVec3 somewhere{Rational(137, 11), Rational(-71, 13), Rational(53, 17)};

} // namespace halfspace::test
