// What a term comes to: a number or a list of numbers, in unknowns where the term has some.
#pragma once

#include "geometry/vector.h"
#include "lessons/term/real.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace halfspace {

/// A sum of powers of unknowns with their factors, and a number: 3t² − x + 5.
class Polynomial {
public:
  /// A product of unknowns by their letters, sorted: `t`, `t t`, `x y`; never empty.
  using Monomial = std::vector<std::string>;
  struct Summand {
    Monomial monomial;
    Real factor;
  };

  Polynomial() = default; ///< 0
  Polynomial(Real number) : m_constant(std::move(number)) {}
  [[nodiscard]] static Polynomial unknown(const std::string &letter);

  /// Higher powers first, then by letters; none with a factor 0.
  [[nodiscard]] const std::vector<Summand> &summands() const { return m_summands; }
  /// What is left without the unknowns.
  [[nodiscard]] const Real &constant() const { return m_constant; }
  [[nodiscard]] bool hasUnknowns() const { return !m_summands.empty(); }
  /// The number, or null where unknowns are left.
  [[nodiscard]] const Real *number() const { return hasUnknowns() ? nullptr : &m_constant; }

  [[nodiscard]] Polynomial operator-() const;
  friend Polynomial operator+(const Polynomial &a, const Polynomial &b);
  friend Polynomial operator-(const Polynomial &a, const Polynomial &b) { return a + -b; }
  friend Polynomial operator*(const Polynomial &a, const Polynomial &b);

private:
  void add(const Monomial &monomial, const Real &factor);

  Real m_constant = 0;
  std::vector<Summand> m_summands;
};

/// A number has one entry; a list (a vector or point has three) is told apart from it.
struct TermValue {
  std::vector<Polynomial> entries;
  bool isList = false;

  TermValue(Polynomial number) { entries.push_back(std::move(number)); }
  TermValue(Real number) : TermValue(Polynomial(std::move(number))) {}
  TermValue(const Surd &number) : TermValue(Real(number)) {}
  TermValue(const Rational &number) : TermValue(Real(number)) {}
  TermValue(const Vec3<Rational> &vector);
  TermValue(const std::vector<Surd> &list);
  [[nodiscard]] static TermValue list(std::vector<Polynomial> entries);

  /// The number that it is; null for lists, and where unknowns are left.
  [[nodiscard]] const Real *number() const { return isList ? nullptr : entries.front().number(); }

private:
  TermValue() = default;
};

/// Whether every number in it is known as A + B·√n.
[[nodiscard]] bool isExact(const Polynomial &value);
[[nodiscard]] bool isExact(const TermValue &value);

/// The number, or the numbers of the list; nothing where one has unknowns or is not exactly known.
[[nodiscard]] std::optional<std::vector<Surd>> exactNumbers(const TermValue &value);

/// Whether both come to the same for all values of their unknowns; nothing where bounds leave it open.
[[nodiscard]] std::optional<bool> areEqual(const TermValue &a, const TermValue &b);

} // namespace halfspace
