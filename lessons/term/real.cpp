#include "lessons/term/real.h"

#include "geometry/integer.h"
#include "lessons/term/interval.h"

#include <algorithm>
#include <array>
#include <limits>

namespace halfspace {
namespace {

using Bound = Interval::Bound;

/// Wide enough for the rounding of the operation that gave the bounds.
Interval widened(const Bound &low, const Bound &high) {
  static const Bound unit = 4 * std::numeric_limits<Bound>::epsilon();
  return {low - mp::abs(low) * unit, high + mp::abs(high) * unit};
}

Interval boundsOf(const Rational &value) {
  const Bound near = Bound(toText(value.numerator())) / Bound(toText(value.denominator()));
  return widened(near, near);
}

Interval sum(const Interval &a, const Interval &b) { return widened(a.low + b.low, a.high + b.high); }

Interval product(const Interval &a, const Interval &b) {
  const std::array<Bound, 4> corners{a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
  return widened(*low, *high);
}

Interval root(const Interval &square) { return widened(mp::sqrt(square.low), mp::sqrt(square.high)); }

/// 1/divisor, for bounds of the same sign.
Interval reciprocal(const Interval &divisor) { return widened(1 / divisor.high, 1 / divisor.low); }

/// A² − B²n, which is (A + B√n)(A − B√n)
Rational normOf(const Surd &value) {
  return value.rationalPart() * value.rationalPart() -
         value.rootFactor() * value.rootFactor() * value.radicand();
}

Interval boundsOf(const Surd &value) {
  const Rational &a = value.rationalPart();
  const Rational &b = value.rootFactor();
  const Interval radicand = root(boundsOf(value.radicand()));
  if (a.sign() * b.sign() >= 0)
    return sum(boundsOf(a), product(boundsOf(b), radicand));
  // As (A² − B²n)/(A − B√n): the difference itself would lose all digits that both parts have in common.
  return product(boundsOf(normOf(value)),
                 reciprocal(sum(boundsOf(a), product(boundsOf(Rational(-b)), radicand))));
}

Surd made(const Rational &rationalPart, const Rational &rootFactor, const Rational &radicand) {
  return Surd::root(radicand, rootFactor) + rationalPart;
}

/// The number where it is a fraction, else null.
const Rational *fractionOf(const Real &value) {
  const Surd *exact = value.exact();
  return exact && exact->isRational() ? &exact->rationalPart() : nullptr;
}

bool isZero(const Real &value) {
  const Surd *exact = value.exact();
  return exact && exact->sign() == 0;
}

/// A summand's magnitude times 2^bits, cut off.
Integer floorOf(const Surd &summand, int bits) {
  const Rational square = summand.squared().rationalPart();
  return mp::sqrt(Integer((numeratorOf(square) << (2 * bits)) / denominatorOf(square)));
}

/// So many bits of a sum are known after its summands have pulled against each other: all that a bound has.
constexpr unsigned knownBits = std::numeric_limits<Bound>::digits;

/// Each summand is cut off in fixed point, and more bits are added until enough are left of the sum. That
/// happens, as it is not zero.
Interval boundsOf(const RootSum &value) {
  for (int bits = 2 * static_cast<int>(knownBits);; bits *= 2) {
    Integer low = 0;
    Integer high = 0;
    for (const Surd &summand : value.summands()) {
      const Integer magnitude = floorOf(summand, bits);
      low += summand.sign() > 0 ? magnitude : Integer(-magnitude - 1);
      high += summand.sign() > 0 ? Integer(magnitude + 1) : Integer(-magnitude);
    }
    const Integer least = std::max(low, Integer(-high)); // in magnitude, where both have the same sign
    if (least <= 0 || mp::msb(least) < knownBits)
      continue;
    Interval within = widened(mp::ldexp(Bound(low), -bits), mp::ldexp(Bound(high), -bits));
    within.number = value;
    return within;
  }
}

/// The number as a sum of roots, where it is known to be one.
std::optional<RootSum> rootSumOf(const Real &value) {
  if (const Surd *exact = value.exact())
    return RootSum(*exact);
  return value.bounds().number;
}

Real realOf(const RootSum &value) {
  const auto surd = value.surd();
  return surd ? Real(*surd) : Real(boundsOf(value));
}

/// 1/(A + B√n) = (A − B√n)/(A² − B²n)
Surd reciprocal(const Surd &value) {
  if (value.isRational())
    return Rational(1 / value.rationalPart());
  const Surd conjugate = made(value.rationalPart(), -value.rootFactor(), value.radicand());
  return conjugate * Rational(1 / normOf(value));
}

} // namespace

Real::Real(const Interval &within) : m_within(std::make_shared<const Interval>(within)) {}

Interval Real::bounds() const {
  const Surd *surd = exact();
  return surd ? boundsOf(*surd) : *m_within;
}

Real Real::operator-() const {
  if (const Surd *surd = exact())
    return -*surd;
  const Interval within = bounds();
  Interval negated{-within.high, -within.low};
  if (within.number)
    negated.number = -*within.number;
  return Real(negated);
}

Real operator+(const Real &a, const Real &b) {
  const Surd *exact = a.exact();
  if (const Rational *shift = fractionOf(b); exact && shift)
    return *exact + *shift;
  if (fractionOf(a) && b.exact())
    return b + a;
  const auto left = rootSumOf(a);
  const auto right = rootSumOf(b);
  return left && right ? realOf(*left + *right) : Real(sum(a.bounds(), b.bounds()));
}

Real operator*(const Real &a, const Real &b) {
  const Surd *exact = a.exact();
  if (const Rational *scale = fractionOf(b); exact && scale)
    return *exact * *scale;
  if (fractionOf(a) && b.exact())
    return b * a;
  if (isZero(a) || isZero(b))
    return 0;
  const auto left = rootSumOf(a);
  const auto right = rootSumOf(b);
  return left && right ? realOf(*left * *right) : Real(product(a.bounds(), b.bounds()));
}

std::optional<int> sign(const Real &value) {
  if (const Surd *exact = value.exact())
    return exact->sign();
  const Interval within = value.bounds();
  if (within.low > 0)
    return 1;
  return within.high < 0 ? std::optional(-1) : std::nullopt;
}

std::optional<Real> quotient(const Real &a, const Real &b) {
  const auto signOfDivisor = sign(b);
  if (signOfDivisor.value_or(0) == 0)
    return {};
  if (const Surd *exact = b.exact())
    return a * Real(reciprocal(*exact));
  return a * Real(reciprocal(b.bounds()));
}

std::optional<Real> squareRoot(const Real &value) {
  if (sign(value).value_or(-1) < 0)
    return {};
  if (const Surd *exact = value.exact(); exact && exact->isRational())
    return Surd::root(exact->rationalPart());
  return Real(root(value.bounds()));
}

std::optional<bool> areEqual(const Real &a, const Real &b) {
  if (a.exact() && b.exact())
    return *a.exact() == *b.exact();
  const auto order = sign(a - b);
  return order ? std::optional(*order == 0) : std::nullopt;
}

double toDouble(const Real &value) {
  if (const Surd *exact = value.exact())
    return toDouble(*exact);
  const Interval within = value.bounds();
  if (within.low <= 0 && within.high >= 0)
    return 0; // as near as it is known
  return Bound((within.low + within.high) / 2).convert_to<double>();
}

} // namespace halfspace
