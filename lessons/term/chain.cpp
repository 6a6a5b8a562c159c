#include "lessons/term/chain.h"

#include "lessons/term/rewrite.h"
#include "lessons/term/written.h"

namespace halfspace {
namespace {

Relation comparisonOf(const Term &a, const Term &b) {
  const Term difference = a - b;
  const Real *number = numberOf(difference);
  const auto side = number ? sign(*number) : std::nullopt;
  if (!side)
    return Relation::Unequal;
  if (*side == 0)
    return Relation::Equal;
  return *side < 0 ? Relation::Less : Relation::Greater;
}

/// Of two terms that should be equal; nothing where that cannot be known.
std::optional<bool> comeToTheSame(const Term &a, const Term &b) {
  return a->value && b->value ? areEqual(*a->value, *b->value) : std::optional(false);
}

/// Of two sides that are equal by demand: false where no unknown is left that could fulfil it.
std::optional<bool> canBeTheSame(const Term &a, const Term &b) {
  const Term difference = a - b;
  const Real *left = numberOf(difference);
  return left ? areEqual(*left, Real(0)) : std::optional(true);
}

} // namespace

std::vector<Relation> Chain::relations() const {
  // What the first side is not equal to by demand, the others are compared with.
  const std::size_t first = m_claim == Claim::Identity ? 0 : 1;
  std::vector<Relation> relations;
  bool rounded = showsRounded(m_sides[0]);
  for (std::size_t i = 1; i < m_sides.size(); ++i) {
    rounded = rounded || showsRounded(m_sides[i]);
    if (m_claim == Claim::Order || (i == first && m_claim == Claim::Comparison)) {
      relations.push_back(comparisonOf(m_sides[i - 1], m_sides[i]));
      continue;
    }
    const auto same = i != first                 ? comeToTheSame(m_sides[first], m_sides[i])
                      : m_claim == Claim::Demand ? std::optional(true)
                                                 : canBeTheSame(m_sides[0], m_sides[i]);
    relations.push_back(same == false      ? Relation::Unequal
                        : rounded || !same ? Relation::Approximately
                                           : Relation::Equal);
  }
  return relations;
}

Chain Chain::asDemand() const {
  Chain chain = *this;
  if (isCondition())
    chain.m_claim = Claim::Demand;
  return chain;
}

Chain operator==(Chain chain, Term next) {
  chain.m_sides.push_back(std::move(next));
  chain.m_symbolic = chain.m_sides.size();
  return chain;
}

Chain Chain::then(Term calculated) const {
  Chain chain = *this;
  const bool repeats = readAlike(calculated, chain.last());
  if (!repeats)
    chain.m_sides.push_back(std::move(calculated));
  else if (chain.m_sides.size() > chain.m_symbolic)
    chain.m_sides.back() = std::move(calculated);
  return chain;
}

Chain operator==(Term a, Term b) { return Chain(std::move(a)) == std::move(b); }

Chain condition(Chain chain) {
  chain.m_claim = Chain::Claim::Condition;
  return chain;
}

Chain compared(Term a, Term b) {
  Chain chain = std::move(a) == std::move(b);
  chain.m_claim = Chain::Claim::Comparison;
  chain.m_symbolic = 1; // the relation says what the first side is like
  return chain;
}

Chain inOrder(std::vector<Term> terms) {
  Chain chain = std::move(terms.front());
  chain.m_sides.insert(chain.m_sides.end(), std::next(terms.begin()), terms.end());
  chain.m_claim = Chain::Claim::Order;
  return chain;
}

Chain withNumbers(const Chain &chain) {
  return chain.then(numbersPutIn(chain.last())).then(calculated(chain.last()));
}

Chain withProducts(const Chain &chain) {
  return chain.then(multipliedOut(chain.last())).then(calculated(chain.last()));
}

Chain withResult(const Chain &chain) { return chain.then(calculated(chain.last())); }

} // namespace halfspace
