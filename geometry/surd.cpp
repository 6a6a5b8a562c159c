#include "geometry/surd.h"

namespace halfspace {
namespace {

/// root² · rest = a positive integer, rest square-free when `complete`.
struct SquareParts {
  Integer root = 1;
  Integer rest = 1;
  bool complete = true;
};

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

SquareParts splitSquares(const Integer &value) {
  SquareParts parts;
  const Integer root = mp::sqrt(value);
  if (root * root == value) {
    parts.root = root;
    return parts;
  }
  if (value > factorLimit) {
    parts.rest = value;
    parts.complete = false;
    return parts;
  }
  // Below the cube root of what is left every prime is tried. What remains has at most two prime factors: it
  // is square-free unless it is a square itself.
  auto left = value.convert_to<std::uint64_t>();
  for (std::uint64_t prime = 2; prime * prime * prime <= left; prime += prime == 2 ? 1 : 2)
    if (left % prime == 0)
      takePrime(left, prime, parts);
  const Integer last = mp::sqrt(Integer(left));
  if (last * last == left)
    parts.root *= last;
  else
    parts.rest *= left;
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
  const SquareParts p = splitSquares(mp::numerator(whole));
  const SquareParts q = splitSquares(mp::denominator(whole));
  const Rational magnitude(p.root, Integer(q.root * q.rest));
  const Rational outside = factor < 0 ? Rational(-magnitude) : magnitude;
  const Integer inside = p.rest * q.rest;
  if (inside == 1)
    return outside;
  result.m_factor = outside;
  result.m_radicand = inside;
  result.m_canonical = p.complete && q.complete;
  return result;
}

int Surd::sign() const {
  if (isRational())
    return m_rational.sign();
  if (m_rational.sign() * m_factor.sign() >= 0)
    return m_factor.sign();
  // The parts pull apart: the one with the larger square wins; they are never equal, as √n is irrational.
  const bool rootWins = m_factor * m_factor * Rational(m_radicand) > m_rational * m_rational;
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

Surd Surd::operator*(const Rational &scale) const {
  return root(Rational(m_radicand), m_factor * scale) + m_rational * scale;
}

bool Surd::operator==(const Surd &other) const {
  // Squares compare the roots whether or not their radicands could be brought to square-free form.
  const auto rootSquare = [](const Surd &s) {
    return Rational(s.m_factor * s.m_factor * Rational(s.m_radicand));
  };
  return m_rational == other.m_rational && m_factor.sign() == other.m_factor.sign() &&
         rootSquare(*this) == rootSquare(other);
}

double toDouble(const Surd &value) {
  if (value.isRational())
    return toDouble(value.rationalPart());
  // The root is taken in fixed point, B·√n = ±√(B²n); more bits are added until 64 of the sum are true,
  // however much of A and B·√n cancels.
  const Rational square = value.rootFactor() * value.rootFactor() * Rational(value.radicand());
  const Integer p = mp::numerator(square);
  const Integer q = mp::denominator(square);
  for (int bits = 128 + static_cast<int>(mp::msb(q));; bits *= 2) {
    Integer root = mp::sqrt(Integer((p << (2 * bits)) / q));
    if (value.rootFactor() < 0)
      root = -root;
    const Rational sum = value.rationalPart() * Rational(Integer(Integer(1) << bits)) + Rational(root);
    if (sum != 0 && mp::msb(Integer(mp::abs(Integer(mp::numerator(sum) / mp::denominator(sum))) + 1)) >= 64)
      return nearestDouble(mp::numerator(sum), mp::denominator(sum), -bits);
  }
}

std::optional<std::string> toText(const Surd &value) {
  if (!value.canonical())
    return {};
  if (value.isRational())
    return toText(value.rationalPart());
  const Rational &factor = value.rootFactor();
  const bool mixed = value.rationalPart() != 0;
  const Rational magnitude = mixed ? Rational(mp::abs(factor)) : factor;
  std::string text;
  if (mixed)
    text = toText(value.rationalPart()) + (factor < 0 ? " - " : " + ");
  if (magnitude == -1)
    text += "-";
  else if (magnitude != 1)
    text += toText(magnitude) + "*";
  return text + "sqrt(" + value.radicand().str() + ")";
}

} // namespace halfspace
