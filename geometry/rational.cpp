#include "geometry/integer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstdlib>
#include <limits>

namespace halfspace {
namespace {

__extension__ using TwoWords = __int128;

bool fitsWord(TwoWords value) {
  constexpr TwoWords largest = std::numeric_limits<std::int64_t>::max();
  return -largest <= value && value <= largest;
}

bool fitsWord(const Integer &value) { return mp::abs(value) <= std::numeric_limits<std::int64_t>::max(); }

/// Of two words; the result is positive where one of them is not 0. Stein's algorithm without branches that
/// depend on the numbers: std::gcd has one at every step, and takes three times as long.
std::int64_t greatestCommonDivisor(std::int64_t first, std::int64_t second) {
  auto a = static_cast<std::uint64_t>(std::abs(first));
  auto b = static_cast<std::uint64_t>(std::abs(second));
  if (a == 1 || b == 1)
    return 1;
  if (a == 0 || b == 0)
    return static_cast<std::int64_t>(a | b);
  const int commonTwos = std::countr_zero(a | b);
  a >>= std::countr_zero(a);
  while (b != 0) {
    b >>= std::countr_zero(b);
    const std::uint64_t difference = a > b ? a - b : b - a;
    a = std::min(a, b);
    b = difference;
  }
  return static_cast<std::int64_t>(a << commonTwos);
}

/// value mod divisor; the machine divides single words many times faster than double ones.
std::int64_t remainder(TwoWords value, std::int64_t divisor) {
  return fitsWord(value) ? static_cast<std::int64_t>(value) % divisor
                         : static_cast<std::int64_t>(value % divisor);
}

} // namespace

Rational::Rational(Big value) {
  const Integer p = mp::numerator(value.value);
  const Integer q = mp::denominator(value.value);
  if (fitsWord(p) && fitsWord(q))
    *this = fromParts(static_cast<std::int64_t>(p), static_cast<std::int64_t>(q));
  else
    m_big = std::make_shared<const Big>(std::move(value));
}

Rational Rational::beyondWords(bool isNegative, std::uint64_t bits) {
  const Integer magnitude(isNegative ? -bits : bits);
  return rationalOf(isNegative ? Integer(-magnitude) : magnitude);
}

Rational Rational::fromParts(TwoWords numerator, TwoWords denominator) {
  Rational result;
  result.m_numerator = static_cast<std::int64_t>(numerator);
  result.m_denominator = static_cast<std::int64_t>(denominator);
  return result;
}

Rational::Big Rational::big() const {
  return m_big ? *m_big : Big{{Integer(m_numerator), Integer(m_denominator)}};
}

Rational Rational::numerator() const {
  return m_big ? rationalOf(mp::numerator(m_big->value)) : fromParts(m_numerator, 1);
}

Rational Rational::denominator() const {
  return m_big ? rationalOf(mp::denominator(m_big->value)) : fromParts(m_denominator, 1);
}

bool Rational::isInteger() const { return m_big ? mp::denominator(m_big->value) == 1 : m_denominator == 1; }

int Rational::sign() const {
  if (m_big)
    return m_big->value.sign();
  return m_numerator < 0 ? -1 : m_numerator > 0 ? 1 : 0;
}

Rational Rational::operator-() const {
  return m_big ? Rational(Big{-m_big->value}) : fromParts(-m_numerator, m_denominator);
}

// The greatest common divisors are taken before the products, of single words (Knuth, The Art of Computer
// Programming 2, 4.5.1): then no result needs more than two words, and all are in lowest terms.

Rational Rational::plus(const Rational &other) const {
  if (isSmall() && other.isSmall()) {
    const std::int64_t common = greatestCommonDivisor(m_denominator, other.m_denominator);
    const std::int64_t rest = m_denominator / common;
    const TwoWords sum = static_cast<TwoWords>(m_numerator) * (other.m_denominator / common) +
                         static_cast<TwoWords>(other.m_numerator) * rest;
    const std::int64_t divisor = common == 1 ? 1 : greatestCommonDivisor(remainder(sum, common), common);
    const TwoWords numerator = divisor == 1 ? sum : sum / divisor;
    const TwoWords denominator = static_cast<TwoWords>(rest) * (other.m_denominator / divisor);
    if (fitsWord(numerator) && fitsWord(denominator))
      return fromParts(numerator, denominator);
  }
  return Rational(Big{big().value + other.big().value});
}

Rational Rational::times(const Rational &other) const {
  if (isSmall() && other.isSmall()) {
    const std::int64_t left = greatestCommonDivisor(m_numerator, other.m_denominator);
    const std::int64_t right = greatestCommonDivisor(other.m_numerator, m_denominator);
    const TwoWords numerator = static_cast<TwoWords>(m_numerator / left) * (other.m_numerator / right);
    const TwoWords denominator = static_cast<TwoWords>(m_denominator / right) * (other.m_denominator / left);
    if (fitsWord(numerator) && fitsWord(denominator))
      return fromParts(numerator, denominator);
  }
  return Rational(Big{big().value * other.big().value});
}

Rational Rational::over(const Rational &divisor) const {
  assert(divisor.sign() != 0);
  if (!divisor.isSmall())
    return Rational(Big{big().value / divisor.big().value});
  const bool negative = divisor.m_numerator < 0;
  return times(negative ? fromParts(-divisor.m_denominator, -divisor.m_numerator)
                        : fromParts(divisor.m_denominator, divisor.m_numerator));
}

std::strong_ordering Rational::compare(const Rational &other) const {
  if (isSmall() && other.isSmall()) {
    const TwoWords left = static_cast<TwoWords>(m_numerator) * other.m_denominator;
    const TwoWords right = static_cast<TwoWords>(other.m_numerator) * m_denominator;
    return left <=> right;
  }
  return big().value.compare(other.big().value) <=> 0;
}

Integer numeratorOf(const Rational &value) {
  const auto words = value.words();
  return words ? Integer(words->numerator) : Integer(mp::numerator(value.big().value));
}

Integer denominatorOf(const Rational &value) {
  const auto words = value.words();
  return words ? Integer(words->denominator) : Integer(mp::denominator(value.big().value));
}

Integer integerOf(const Rational &whole) {
  assert(whole.isInteger());
  return numeratorOf(whole);
}

Rational rationalOf(const Integer &value) {
  return fitsWord(value) ? Rational(static_cast<std::int64_t>(value)) : Rational(Rational::Big{value});
}

Rational powerOfTen(int exponent) {
  static const auto words = [] {
    std::array<std::int64_t, std::numeric_limits<std::int64_t>::digits10 + 1> powers{1}; // all that fit
    for (std::size_t i = 1; i < powers.size(); ++i)
      powers[i] = powers[i - 1] * 10;
    return powers;
  }();
  const auto power = static_cast<std::size_t>(std::abs(exponent));
  const Rational value = power < words.size()
                             ? Rational(words[power])
                             : rationalOf(mp::pow(Integer(10), static_cast<unsigned>(power)));
  return exponent < 0 ? 1 / value : value;
}

} // namespace halfspace
