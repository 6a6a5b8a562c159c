// Fractions as doubles, as whole numbers and as multiples of a step.
#include "geometry/integer.h"

#include <algorithm>
#include <cmath>

namespace halfspace {
namespace {

int bitLength(const Integer &positive) { return static_cast<int>(mp::msb(positive)) + 1; }

} // namespace

double nearestDouble(const Integer &p, const Integer &q, int exponent) {
  if (p == 0)
    return 0;
  const Integer magnitude = mp::abs(p);

  // Scale so that the quotient has 65 or 66 bits, more than a double's 53; a last odd bit stands for all that
  // the division cut off, so that the one rounding below rounds the true value.
  const int shift = 65 - (bitLength(magnitude) - bitLength(q));
  const Integer dividend = shift > 0 ? Integer(magnitude << shift) : magnitude;
  const Integer divisor = shift < 0 ? Integer(q << -shift) : q;
  Integer quotient;
  Integer remainder;
  mp::divide_qr(dividend, divisor, quotient, remainder);
  if (remainder != 0)
    quotient |= 1;

  // Keep the bits that a double of this size has: 53, fewer when it is subnormal.
  const int top = bitLength(quotient) - shift + exponent;
  const int kept =
      std::min(std::numeric_limits<double>::digits,
               top - (std::numeric_limits<double>::min_exponent - std::numeric_limits<double>::digits));
  if (kept < 0)
    return p < 0 ? -0.0 : 0.0;
  const int dropped = bitLength(quotient) - kept;
  Integer mantissa = quotient >> dropped;
  const Integer rest = quotient - (mantissa << dropped);
  const Integer half = Integer(1) << (dropped - 1);
  if (rest > half || (rest == half && mp::bit_test(mantissa, 0)))
    ++mantissa;
  const double value = std::ldexp(mantissa.convert_to<double>(), dropped - shift + exponent);
  return p < 0 ? -value : value;
}

double toDouble(const Rational &value) {
  // Where both parts are doubles the one division below rounds once.
  constexpr std::int64_t largestWhole = std::int64_t{1} << std::numeric_limits<double>::digits;
  const auto words = value.words();
  if (words && std::abs(words->numerator) <= largestWhole && words->denominator <= largestWhole)
    return static_cast<double>(words->numerator) / static_cast<double>(words->denominator);
  const BigFraction big = value.big().value;
  return nearestDouble(mp::numerator(big), mp::denominator(big));
}

Rational exactly(double value) {
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  constexpr int digits = std::numeric_limits<double>::digits;
  const Integer whole(static_cast<std::int64_t>(std::ldexp(mantissa, digits)));
  exponent -= digits;
  const Rational power = rationalOf(Integer(1) << std::abs(exponent));
  return exponent >= 0 ? rationalOf(whole) * power : rationalOf(whole) / power;
}

Rational floorOf(const Rational &value) {
  const Integer p = numeratorOf(value);
  const Integer q = denominatorOf(value);
  Integer floor = p / q;
  if (p < 0 && floor * q != p)
    --floor;
  return rationalOf(floor);
}

Rational roundToMultiple(const Rational &value, const Rational &step) {
  return floorOf(value / step + Rational(1, 2)) * step;
}

Rational roundUpToMultiple(const Rational &value, const Rational &step) {
  return -floorOf(-value / step) * step;
}

Rational roundToMultiple(double value, const Rational &step) { return roundToMultiple(exactly(value), step); }

} // namespace halfspace
