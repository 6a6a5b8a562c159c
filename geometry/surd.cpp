#include "geometry/surd.h"

#include "geometry/integer.h"

#include <limits>
#include <vector>

namespace halfspace {
namespace {

/// root² · rest = a positive integer, rest square-free when `complete`.
struct SquareParts {
  Integer root = 1;
  Integer rest = 1;
  bool complete = true;
};

/// An odd prime, prepared so that one product tells whether it divides a word: exactly the multiples of an
/// odd number, times its inverse modulo 2^64, are at most the largest word divided by it (Granlund and
/// Montgomery, Division by invariant integers, 1994, section 9).
struct Divisor {
  explicit Divisor(std::uint64_t oddPrime)
      : prime(oddPrime), inverse(oddPrime),
        largestQuotient(std::numeric_limits<std::uint64_t>::max() / oddPrime) {
    // Newton's iteration: each step doubles the number of true bits, and an odd number is its own inverse
    // modulo 8.
    for (int bits = 3; bits < std::numeric_limits<std::uint64_t>::digits; bits *= 2)
      inverse *= 2 - prime * inverse;
  }
  [[nodiscard]] bool divides(std::uint64_t value) const { return value * inverse <= largestQuotient; }

  std::uint64_t prime;
  std::uint64_t inverse;
  std::uint64_t largestQuotient;
};

/// All odd primes up to the cube root of `factorLimit`.
std::vector<Divisor> sieveDivisors() {
  constexpr std::size_t largest = 1'000'000;
  std::vector<bool> composite(largest + 1);
  std::vector<Divisor> divisors;
  for (std::size_t n = 3; n <= largest; n += 2) {
    if (composite[n])
      continue;
    divisors.emplace_back(n);
    for (std::size_t multiple = n * n; multiple <= largest; multiple += 2 * n)
      composite[multiple] = true;
  }
  return divisors;
}

/// Moves a prime's even powers from `value` to `parts.root` and an odd one left to `parts.rest`.
void takePrime(std::uint64_t &value, std::uint64_t prime, SquareParts &parts) {
  const std::uint64_t square = prime * prime;
  while (value % square == 0) {
    value /= square;
    parts.root *= prime;
  }
  if (value % prime == 0) {
    value /= prime;
    parts.rest *= prime;
  }
}

std::uint64_t rootOf(std::uint64_t value) {
  auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(value)));
  while (root * root > value)
    --root;
  while ((root + 1) * (root + 1) <= value)
    ++root;
  return root;
}

/// For a value of at most `factorLimit`.
SquareParts splitSmall(std::uint64_t value) {
  SquareParts parts;
  if (const std::uint64_t root = rootOf(value); root * root == value) {
    parts.root = root;
    return parts;
  }
  // Below the cube root of what is left every prime is tried. What remains has at most two prime factors: it
  // is square-free unless it is a square itself.
  static const std::vector<Divisor> oddPrimes = sieveDivisors();
  takePrime(value, 2, parts);
  for (const Divisor &divisor : oddPrimes) {
    if (divisor.prime * divisor.prime * divisor.prime > value)
      break;
    if (divisor.divides(value))
      takePrime(value, divisor.prime, parts);
  }
  if (const std::uint64_t last = rootOf(value); last * last == value)
    parts.root *= last;
  else
    parts.rest *= value;
  return parts;
}

SquareParts splitSquares(const Integer &value) {
  if (value <= factorLimit)
    return splitSmall(static_cast<std::uint64_t>(value));
  SquareParts parts;
  const Integer root = mp::sqrt(value);
  if (root * root == value) {
    parts.root = root;
  } else {
    parts.rest = value;
    parts.complete = false;
  }
  return parts;
}

} // namespace

Surd Surd::root(const Rational &square, const Rational &factor) {
  Surd result;
  if (square == 0 || factor == 0)
    return result;
  // B·√n = ±√(B²n), so the form depends on the value alone and not on how it was come by.
  // √(p/q) = root(p)/(root(q)·rest(q)) · √(rest(p)·rest(q)), square-free because p and q share no factor.
  const Rational whole = square * factor * factor;
  const SquareParts p = splitSquares(numeratorOf(whole));
  const SquareParts q = splitSquares(denominatorOf(whole));
  const Rational magnitude = rationalOf(p.root) / rationalOf(q.root * q.rest);
  const Rational outside = factor < 0 ? Rational(-magnitude) : magnitude;
  const Integer inside = p.rest * q.rest;
  if (inside == 1)
    return outside;
  result.m_factor = outside;
  result.m_radicand = rationalOf(inside);
  result.m_canonical = p.complete && q.complete;
  return result;
}

int Surd::sign() const {
  if (isRational())
    return m_rational.sign();
  if (m_rational.sign() * m_factor.sign() >= 0)
    return m_factor.sign();
  // The parts pull apart: the one with the larger square wins; they are never equal, as √n is irrational.
  const bool rootWins = m_factor * m_factor * m_radicand > m_rational * m_rational;
  return rootWins ? m_factor.sign() : m_rational.sign();
}

Surd Surd::operator-() const {
  Surd result = *this;
  result.m_rational = -m_rational;
  result.m_factor = -m_factor;
  return result;
}

Surd Surd::operator+(const Rational &shift) const {
  Surd result = *this;
  result.m_rational += shift;
  return result;
}

bool Surd::isWithinFactorLimit() const {
  // B²n = p/q in lowest terms, found without factors as n is square-free: p and q are squares but for the
  // parts of n that they keep.
  const Integer radicand = integerOf(m_radicand);
  const Integer denominator = denominatorOf(m_factor);
  const Integer shared = mp::gcd(radicand, denominator);
  const Integer rest = radicand / shared;
  const Integer numerator = numeratorOf(m_factor);
  return (rest == 1 || numerator * numerator * rest <= factorLimit) &&
         (shared == 1 || denominator * denominator / shared <= factorLimit);
}

Surd Surd::operator*(const Rational &scale) const {
  if (isRational() || scale == 0)
    return m_rational * scale;
  if (!m_canonical)
    return root(m_radicand, m_factor * scale) + m_rational * scale;
  Surd result = *this;
  result.m_rational = m_rational * scale;
  result.m_factor = m_factor * scale;
  result.m_canonical = result.isWithinFactorLimit();
  return result;
}

bool Surd::operator==(const Surd &other) const {
  // Squares compare the roots whether or not their radicands could be brought to square-free form.
  const auto rootSquare = [](const Surd &s) { return Rational(s.m_factor * s.m_factor * s.m_radicand); };
  return m_rational == other.m_rational && m_factor.sign() == other.m_factor.sign() &&
         rootSquare(*this) == rootSquare(other);
}

Surd Surd::squared() const {
  return root(m_radicand, 2 * m_rational * m_factor) + m_rational * m_rational +
         m_factor * m_factor * m_radicand;
}

std::strong_ordering Surd::operator<=>(const Surd &other) const {
  const Surd difference = *this + (-other.m_rational);
  const int sign = difference.sign();
  const int rootSign = other.m_factor.sign(); // of the root that is taken away
  if (sign * rootSign <= 0)
    return sign != 0 ? sign <=> 0 : 0 <=> rootSign;
  // The parts pull apart: the one with the larger square wins.
  const Surd squares = difference.squared() + (-other.m_factor * other.m_factor * other.m_radicand);
  return sign * squares.sign() <=> 0;
}

namespace {

/// The sum A + B·√n in long doubles, where these hold a whole word and their rounding leaves no doubt which
/// double is nearest.
std::optional<double> quickDouble(const Surd &value) {
  if constexpr (std::numeric_limits<long double>::digits < std::numeric_limits<std::int64_t>::digits)
    return {};
  const auto rational = value.rationalPart().words();
  const auto factor = value.rootFactor().words();
  const auto radicand = value.radicand().words();
  if (!rational || !factor || !radicand)
    return {};
  const auto quotient = [](const Rational::Words &words) {
    return static_cast<long double>(words.numerator) / static_cast<long double>(words.denominator);
  };
  const long double whole = quotient(*rational);
  const long double root = quotient(*factor) * std::sqrt(static_cast<long double>(radicand->numerator));
  const long double sum = whole + root;
  // A is rounded once, B·√n three times, and their sum once, each time by epsilon/2 at most: less than half
  // of this, which also covers the two roundings below.
  const long double margin =
      4 * std::numeric_limits<long double>::epsilon() * (std::abs(whole) + std::abs(root));
  const auto low = static_cast<double>(sum - margin);
  const auto high = static_cast<double>(sum + margin);
  return low == high ? std::optional(low) : std::nullopt;
}

} // namespace

double toDouble(const Surd &value) {
  if (value.isRational())
    return toDouble(value.rationalPart());
  if (const auto quick = quickDouble(value))
    return *quick;
  // The root is taken in fixed point, B·√n = ±√(B²n), and cut off: the sum lies between what comes of it and
  // of the next number. More bits are added until both are nearest to the same double, which happens, as the
  // sum is irrational and never in the middle between two.
  const Rational square = value.rootFactor() * value.rootFactor() * value.radicand();
  const Integer p = numeratorOf(square);
  const Integer q = denominatorOf(square);
  for (int bits = 128 + static_cast<int>(mp::msb(q));; bits *= 2) {
    const Rational shifted = value.rationalPart() * rationalOf(Integer(1) << bits);
    const Integer root = mp::sqrt(Integer((p << (2 * bits)) / q));
    const auto sumWith = [&](const Integer &magnitude) {
      const Rational sum = shifted + rationalOf(value.rootFactor() < 0 ? Integer(-magnitude) : magnitude);
      return nearestDouble(numeratorOf(sum), denominatorOf(sum), -bits);
    };
    const double sum = sumWith(root);
    if (sum == sumWith(root + 1))
      return sum;
  }
}

std::optional<std::string> toText(const Surd &value) {
  if (!value.canonical())
    return {};
  if (value.isRational())
    return toText(value.rationalPart());
  const Rational &factor = value.rootFactor();
  const bool mixed = value.rationalPart() != 0;
  const Rational magnitude = mixed ? abs(factor) : factor;
  std::string text;
  if (mixed)
    text = toText(value.rationalPart()) + (factor < 0 ? " - " : " + ");
  if (magnitude == -1)
    text += "-";
  else if (magnitude != 1)
    text += toText(magnitude) + "*";
  return text + "sqrt(" + toText(value.radicand()) + ")";
}

} // namespace halfspace
