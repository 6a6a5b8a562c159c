#include "lessons/term/root_sum.h"

#include <algorithm>

namespace halfspace {
namespace {

/// The product of two fractions or roots.
Surd productOf(const Surd &a, const Surd &b) {
  if (a.isRational())
    return b * a.rationalPart();
  if (b.isRational())
    return a * b.rationalPart();
  return Surd::root(a.radicand() * b.radicand(), a.rootFactor() * b.rootFactor());
}

/// a/b of two fractions or roots, where that is a fraction.
std::optional<Rational> ratioOf(const Surd &a, const Surd &b) {
  const bool areSquareFree = a.canonical() && b.canonical();
  if (areSquareFree && a.radicand() != b.radicand())
    return {};
  const Surd product = productOf(a, b);
  return product.isRational() ? std::optional(product.rationalPart() / b.squared().rationalPart())
                              : std::nullopt;
}

} // namespace

RootSum::RootSum(const Surd &value) {
  add(value.rationalPart());
  add(value + Rational(-value.rationalPart()));
}

void RootSum::add(const Surd &summand) {
  if (summand.sign() == 0)
    return;
  for (auto own = m_summands.begin(); own != m_summands.end(); ++own)
    if (const auto ratio = ratioOf(summand, *own)) {
      *own = *own * Rational(*ratio + 1);
      if (own->sign() == 0)
        m_summands.erase(own);
      return;
    }
  m_summands.push_back(summand);
}

RootSum RootSum::operator-() const {
  RootSum negated = *this;
  for (Surd &summand : negated.m_summands)
    summand = -summand;
  return negated;
}

RootSum operator+(const RootSum &a, const RootSum &b) {
  RootSum sum = a;
  for (const Surd &summand : b.m_summands)
    sum.add(summand);
  return sum;
}

RootSum operator*(const RootSum &a, const RootSum &b) {
  RootSum product;
  for (const Surd &left : a.m_summands)
    for (const Surd &right : b.m_summands)
      product.add(productOf(left, right));
  return product;
}

std::optional<Surd> RootSum::surd() const {
  Rational fraction;
  Surd root;
  for (const Surd &summand : m_summands) {
    if (summand.isRational())
      fraction = summand.rationalPart();
    else if (root.isRational())
      root = summand;
    else
      return {};
  }
  return root + fraction;
}

} // namespace halfspace
