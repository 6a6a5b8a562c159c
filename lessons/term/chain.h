// Chains of terms, `a = b = c`, whose relations follow from what the terms come to.
#pragma once

#include "lessons/term/term.h"

#include <span>
#include <vector>

namespace halfspace {

enum class Relation : std::uint8_t {
  Equal,         ///< both sides are the same, and all numbers in them are exact
  Approximately, ///< a number was rounded, here or before
  Less,
  Greater,
  Unequal, ///< nothing fulfils the demand; in other chains a defect of whoever built it
};

/// Terms that are claimed to be equal, from left to right; its relations are derived, never written.
class Chain {
public:
  Chain(Term first)
      : m_sides{std::move(first)} {} // NOLINT(google-explicit-constructor): a term is a short chain

  [[nodiscard]] const std::vector<Term> &sides() const { return m_sides; }
  [[nodiscard]] const Term &last() const { return m_sides.back(); }
  /// How many sides stand there in symbols; those behind them were calculated from them.
  [[nodiscard]] std::size_t symbolic() const { return m_symbolic; }
  [[nodiscard]] std::span<const Term> symbols() const { return std::span(m_sides).first(m_symbolic); }
  /// Whether its sides are the same whatever the unknowns are: neither a condition nor a comparison.
  [[nodiscard]] bool isIdentity() const { return m_claim == Claim::Identity; }
  /// The chain, and where it is a condition, nothing of whether anything can fulfil it.
  [[nodiscard]] Chain asDemand() const;
  /// How what it comes to is found: its last side in symbols; of a condition, the first that is demanded to
  /// be equal.
  [[nodiscard]] const Term &formula() const {
    return m_sides[isCondition() && m_symbolic == 1 ? 1 : m_symbolic - 1];
  }
  /// The relation before each side but the first.
  [[nodiscard]] std::vector<Relation> relations() const;

  /// The chain goes on in symbols.
  friend Chain operator==(Chain chain, Term next);
  /// The chain goes on with a calculated side, unless that reads like the one before it: then it replaces it
  /// when that was calculated too.
  [[nodiscard]] Chain then(Term calculated) const;

private:
  enum class Claim : std::uint8_t { Identity, Condition, Demand, Comparison, Order };
  [[nodiscard]] bool isCondition() const { return m_claim == Claim::Condition || m_claim == Claim::Demand; }
  friend Chain condition(Chain chain);
  friend Chain compared(Term a, Term b);
  friend Chain inOrder(std::vector<Term> terms);

  std::vector<Term> m_sides;
  std::size_t m_symbolic = 1;
  Claim m_claim = Claim::Identity;
};

[[nodiscard]] Chain operator==(Term a, Term b);

/// `0 = …`, of two sides and more, which its unknowns fulfil or not: the first side is equal to the second by
/// demand.
[[nodiscard]] Chain condition(Chain chain);

/// a < b, a = b or a > b, whichever holds.
[[nodiscard]] Chain compared(Term a, Term b);

/// a < b = c < …: terms that stand in the order of their values, at least one.
[[nodiscard]] Chain inOrder(std::vector<Term> terms);

/// Goes on with the numbers put in, and the result.
[[nodiscard]] Chain withNumbers(const Chain &chain);
/// Goes on with all products of vectors multiplied out, and the result.
[[nodiscard]] Chain withProducts(const Chain &chain);
/// Goes on with the result.
[[nodiscard]] Chain withResult(const Chain &chain);

} // namespace halfspace
