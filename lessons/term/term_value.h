// What a term comes to: a number or a list of numbers, in unknowns where the term has some.
#pragma once

#include "geometry/vector.h"
#include "lessons/term/real.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halfspace {

/// A sum of powers of unknowns with their factors: 3t² − x + 5. Without unknowns it is a number.
class Polynomial {
public:
  /// A product of unknowns by their letters, sorted: `t`, `tt`, `xy`; empty for the constant.
  using Monomial = std::vector<std::string>;
  struct Summand {
    Monomial monomial;
    Real factor;
  };

  Polynomial() = default;  ///< 0
  Polynomial(Real number); // NOLINT(google-explicit-constructor): every number is one
  [[nodiscard]] static Polynomial unknown(const std::string &letter);

  /// Higher powers first, then by letters, the constant last; none of them zero.
  [[nodiscard]] const std::vector<Summand> &summands() const { return m_summands; }
  /// The number, or nothing where unknowns are left.
  [[nodiscard]] std::optional<Real> number() const;
  [[nodiscard]] bool hasUnknowns() const { return !number(); }

  [[nodiscard]] Polynomial operator-() const;
  friend Polynomial operator+(const Polynomial &a, const Polynomial &b);
  [[nodiscard]] friend Polynomial operator-(const Polynomial &a, const Polynomial &b) { return a + -b; }
  friend Polynomial operator*(const Polynomial &a, const Polynomial &b);

private:
  void add(const Monomial &monomial, const Real &factor);

  std::vector<Summand> m_summands;
};

/// A number has one entry, a list (a vector or point has three) is told apart from it.
struct TermValue {
  std::vector<Polynomial> entries;
  bool isList = false;

  TermValue() = default;
  TermValue(Polynomial number) : entries{std::move(number)} {}         // NOLINT(google-explicit-constructor)
  TermValue(Real number) : TermValue(Polynomial(std::move(number))) {} // NOLINT(google-explicit-constructor)
  TermValue(const Surd &number) : TermValue(Real(number)) {}           // NOLINT(google-explicit-constructor)
  TermValue(const Rational &number) : TermValue(Real(number)) {}       // NOLINT(google-explicit-constructor)
  TermValue(const Vec3<Rational> &vector);                             // NOLINT(google-explicit-constructor)
  TermValue(const std::vector<Surd> &list);                            // NOLINT(google-explicit-constructor)
  [[nodiscard]] static TermValue list(std::vector<Polynomial> entries);

  /// The number that it is; nothing for lists, and where unknowns are left.
  [[nodiscard]] std::optional<Real> number() const;
  [[nodiscard]] bool hasUnknowns() const;
};

/// Whether both come to the same for all values of their unknowns; nothing where bounds leave it open.
[[nodiscard]] std::optional<bool> areEqual(const TermValue &a, const TermValue &b);

} // namespace halfspace
