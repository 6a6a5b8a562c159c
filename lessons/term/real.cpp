#include "lessons/term/real.h"

#include "lessons/term/interval.h"

#include <algorithm>
#include <array>
#include <limits>

namespace halfspace {
namespace {

namespace mp = boost::multiprecision;
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

/// Nothing where the sum has two different roots.
std::optional<Surd> exactSum(const Surd &a, const Surd &b) {
  if (b.isRational())
    return a + b.rationalPart();
  if (a.isRational())
    return b + a.rationalPart();
  if (a.radicand() != b.radicand())
    return {};
  return made(a.rationalPart() + b.rationalPart(), a.rootFactor() + b.rootFactor(), a.radicand());
}

std::optional<Surd> exactProduct(const Surd &a, const Surd &b) {
  if (b.isRational())
    return a * b.rationalPart();
  if (a.isRational())
    return b * a.rationalPart();
  if (a.radicand() == b.radicand()) {
    const Rational &n = a.radicand();
    return made(a.rationalPart() * b.rationalPart() + a.rootFactor() * b.rootFactor() * n,
                a.rationalPart() * b.rootFactor() + a.rootFactor() * b.rationalPart(), n);
  }
  if (a.rationalPart() == 0 && b.rationalPart() == 0)
    return Surd::root(a.radicand() * b.radicand(), a.rootFactor() * b.rootFactor());
  return {};
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
  return Real(Interval{-within.high, -within.low});
}

Real operator+(const Real &a, const Real &b) {
  if (a.exact() && b.exact())
    if (const auto exact = exactSum(*a.exact(), *b.exact()))
      return *exact;
  return Real(sum(a.bounds(), b.bounds()));
}

Real operator*(const Real &a, const Real &b) {
  if (a.exact() && b.exact())
    if (const auto exact = exactProduct(*a.exact(), *b.exact()))
      return *exact;
  return Real(product(a.bounds(), b.bounds()));
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
  const Interval left = a.bounds();
  const Interval right = b.bounds();
  return left.high < right.low || right.high < left.low ? std::optional(false) : std::nullopt;
}

double toDouble(const Real &value) {
  if (const Surd *exact = value.exact())
    return toDouble(*exact);
  const Interval within = value.bounds();
  return Bound((within.low + within.high) / 2).convert_to<double>();
}

} // namespace halfspace
