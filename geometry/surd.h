// Exact lengths: A + B·√n.
#pragma once

#include "geometry/rational.h"

#include <cmath>
#include <compare>

namespace halfspace {

/// The exact value A + B·√n that a length, a normalized coefficient or a root of a quadratic has.
///
/// Canonical form: n is a square-free integer > 1 and B ≠ 0, or n = 1 and B = 0 (a plain fraction); equal
/// values then have equal parts. Where n would need the factors of a number beyond `factorLimit` that is no
/// square, n stays as it is and `canonical()` is false; the value is exact all the same.
class Surd {
public:
  Surd() = default;
  Surd(Rational value)
      : m_rational(std::move(value)) {}  // NOLINT(google-explicit-constructor): every fraction is one
  Surd(int value) : m_rational(value) {} // NOLINT(google-explicit-constructor)

  /// factor · √square. Requires square ≥ 0.
  /// (1) Its square is factor²·square, and its sign that of the factor unless it is 0.
  /// (2) The form depends on the value alone: root(k²·square, factor) and root(square, k·factor) are the same
  ///     part for part, for k ≥ 0.
  [[nodiscard]] static Surd root(const Rational &square, const Rational &factor = 1);

  [[nodiscard]] const Rational &rationalPart() const { return m_rational; }
  [[nodiscard]] const Rational &rootFactor() const { return m_factor; }
  /// A whole number.
  [[nodiscard]] const Rational &radicand() const { return m_radicand; }
  [[nodiscard]] bool isRational() const { return m_factor == 0; }
  [[nodiscard]] bool canonical() const { return m_canonical; }

  /// −1, 0 or 1, exactly.
  /// (1) The sign of −x is the opposite one.
  /// (2) sign(A + B√n)·sign(A − B√n) = sign(A² − B²n).
  [[nodiscard]] int sign() const;

  /// This and the next two are exact, and canonical wherever their value can be.
  /// (1) (x + r)·k = x·k + r·k.
  /// (2) −x = x·(−1).
  /// (3) x + r + (−r) = x, and x·k·(1/k) = x for k ≠ 0.
  [[nodiscard]] Surd operator-() const;
  [[nodiscard]] Surd operator+(const Rational &shift) const;
  [[nodiscard]] Surd operator*(const Rational &scale) const;

  /// x², exactly.
  /// (1) (−x)² = x².
  /// (2) (B·√n)² = B²·n.
  [[nodiscard]] Surd squared() const;

  /// Whether the values are equal, canonical or not.
  [[nodiscard]] bool operator==(const Surd &other) const;
  /// The order of the values, exactly, whatever their radicands.
  /// (1) x < y < z gives x < z, and x < y gives −y < −x.
  [[nodiscard]] std::strong_ordering operator<=>(const Surd &other) const;

private:
  /// Whether this form tells the value's square-free radicand without factoring beyond the limit.
  [[nodiscard]] bool isWithinFactorLimit() const;

  Rational m_rational = 0;
  Rational m_factor = 0;
  Rational m_radicand = 1;
  bool m_canonical = true;
};

/// The largest number that is factored to find the square-free part of a radicand.
inline constexpr std::int64_t factorLimit = 1'000'000'000'000'000'000;

/// The double nearest to the exact value; ±infinity beyond their range.
/// (1) toDouble(−x) = −toDouble(x).
[[nodiscard]] double toDouble(const Surd &value);

/// `A`, `B*sqrt(n)`, `A + B*sqrt(n)` or `A - B*sqrt(n)`; nothing where the value is not canonical.
/// (1) Equal values have the same text, or neither has one.
[[nodiscard]] std::optional<std::string> toText(const Surd &value);

/// The type of a square root over a scalar: double stays double, fractions become surds.
template <class Scalar> struct RootOf;
template <> struct RootOf<double> { using Type = double; };
template <> struct RootOf<Rational> { using Type = Surd; };
template <class Scalar> using Root = typename RootOf<Scalar>::Type;

/// factor·√square. Requires square ≥ 0.
[[nodiscard]] inline double timesRoot(double factor, double square) { return factor * std::sqrt(square); }
[[nodiscard]] inline Surd timesRoot(const Rational &factor, const Rational &square) {
  return Surd::root(square, factor);
}

/// value/√square: what normalizing does to a number. Requires square > 0.
/// (1) overRoot(k·value, k²·square) = overRoot(value, square) for k > 0.
/// (2) overRoot(value, square)·square = timesRoot(value, square), which is value·√square.
[[nodiscard]] inline double overRoot(double value, double square) { return value / std::sqrt(square); }
[[nodiscard]] inline Surd overRoot(const Rational &value, const Rational &square) {
  return Surd::root(square, value / square);
}

} // namespace halfspace
