// Integers of any size, for what fractions cannot be asked: common divisors, roots, bits. To compile it takes
// seconds: headers that others include do without.
#pragma once

#include "geometry/rational.h"

#ifdef HALFSPACE_GMP
#include <boost/multiprecision/gmp.hpp>
#else
#include <boost/multiprecision/cpp_int.hpp>
#endif

namespace halfspace {

namespace mp = boost::multiprecision;

/// Expression templates are off: GLM and `auto` need plain values.
#ifdef HALFSPACE_GMP
using Integer = mp::number<mp::gmp_int, mp::et_off>;
using BigFraction = mp::number<mp::gmp_rational, mp::et_off>;
#else
using Integer = mp::number<mp::cpp_int_backend<>, mp::et_off>;
using BigFraction = mp::number<mp::cpp_rational_backend, mp::et_off>;
#endif

struct Rational::Big {
  BigFraction value;
};

/// `numerator` and `denominator` of a fraction.
[[nodiscard]] Integer numeratorOf(const Rational &value);
[[nodiscard]] Integer denominatorOf(const Rational &value);

/// Requires a whole number.
[[nodiscard]] Integer integerOf(const Rational &whole);

/// (1) integerOf(rationalOf(x)) = x.
[[nodiscard]] Rational rationalOf(const Integer &value);

/// The double nearest to p/q·2^exponent; ±infinity beyond the range of doubles. Requires q > 0.
/// (1) It is `toDouble` of that number.
[[nodiscard]] double nearestDouble(const Integer &p, const Integer &q, int exponent = 0);

} // namespace halfspace
