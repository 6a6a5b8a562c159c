// Real numbers as a term comes to them: exact as long as A + B·√n holds them, else between two bounds.
#pragma once

#include "geometry/surd.h"

#include <memory>
#include <optional>
#include <utility>

namespace halfspace {

struct Interval; // lessons/term/interval.h

class Real {
public:
  Real(Surd value) : m_exact(std::move(value)) {} // NOLINT(google-explicit-constructor): every surd is one
  Real(Rational value) : Real(Surd(std::move(value))) {} // NOLINT(google-explicit-constructor)
  Real(int value) : Real(Surd(value)) {}                 // NOLINT(google-explicit-constructor)
  explicit Real(const Interval &within);

  /// The value where it is A + B·√n; null where it is only known to lie between bounds.
  [[nodiscard]] const Surd *exact() const { return m_within ? nullptr : &m_exact; }
  [[nodiscard]] Interval bounds() const;

  [[nodiscard]] Real operator-() const;
  friend Real operator+(const Real &a, const Real &b);
  [[nodiscard]] friend Real operator-(const Real &a, const Real &b) { return a + -b; }
  friend Real operator*(const Real &a, const Real &b);

private:
  Surd m_exact;
  /// The bounds of what is not exact; rare, large, and never changed.
  std::shared_ptr<const Interval> m_within;
};

/// Nothing where the bounds leave it open.
[[nodiscard]] std::optional<int> sign(const Real &value);

/// a/b; nothing where b is zero, or may be.
[[nodiscard]] std::optional<Real> quotient(const Real &a, const Real &b);

/// √value; nothing below zero, or where the value may be.
[[nodiscard]] std::optional<Real> squareRoot(const Real &value);

/// Whether both are the same number; nothing where the bounds leave it open.
[[nodiscard]] std::optional<bool> areEqual(const Real &a, const Real &b);

[[nodiscard]] double toDouble(const Real &value);

} // namespace halfspace
