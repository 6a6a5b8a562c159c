#include "lessons/term/term_value.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Whether a stands before b when a polynomial is written down.
bool standsBefore(const Polynomial::Monomial &a, const Polynomial::Monomial &b) {
  return a.size() != b.size() ? a.size() > b.size() : a < b;
}

Polynomial::Monomial product(const Polynomial::Monomial &a, const Polynomial::Monomial &b) {
  Polynomial::Monomial letters = a;
  letters.insert(letters.end(), b.begin(), b.end());
  std::sort(letters.begin(), letters.end());
  return letters;
}

bool isZero(const Real &number) { return number.exact() && *number.exact() == Surd(0); }

/// False when one is certainly not zero, nothing when one may be.
std::optional<bool> areAllZero(const std::vector<Polynomial::Summand> &summands) {
  std::optional<bool> all = true;
  for (const Polynomial::Summand &summand : summands) {
    const auto zero = areEqual(summand.factor, Real(0));
    if (zero == false)
      return false;
    if (!zero)
      all.reset();
  }
  return all;
}

} // namespace

Polynomial::Polynomial(Real number) { add({}, number); }

Polynomial Polynomial::unknown(const std::string &letter) {
  Polynomial polynomial;
  polynomial.add({letter}, Real(1));
  return polynomial;
}

std::optional<Real> Polynomial::number() const {
  if (m_summands.empty())
    return Real(0);
  return m_summands.size() == 1 && m_summands[0].monomial.empty() ? std::optional(m_summands[0].factor)
                                                                  : std::nullopt;
}

void Polynomial::add(const Monomial &monomial, const Real &factor) {
  const auto at = std::find_if(m_summands.begin(), m_summands.end(),
                               [&](const Summand &each) { return !standsBefore(each.monomial, monomial); });
  if (at == m_summands.end() || at->monomial != monomial) {
    if (!isZero(factor))
      m_summands.insert(at, {monomial, factor});
    return;
  }
  at->factor = at->factor + factor;
  if (isZero(at->factor))
    m_summands.erase(at);
}

Polynomial Polynomial::operator-() const {
  Polynomial negated = *this;
  for (Summand &summand : negated.m_summands)
    summand.factor = -summand.factor;
  return negated;
}

Polynomial operator+(const Polynomial &a, const Polynomial &b) {
  Polynomial sum = a;
  for (const Polynomial::Summand &summand : b.m_summands)
    sum.add(summand.monomial, summand.factor);
  return sum;
}

Polynomial operator*(const Polynomial &a, const Polynomial &b) {
  Polynomial all;
  for (const Polynomial::Summand &left : a.m_summands)
    for (const Polynomial::Summand &right : b.m_summands)
      all.add(product(left.monomial, right.monomial), left.factor * right.factor);
  return all;
}

TermValue::TermValue(const Vec3<Rational> &vector)
    : entries{Real(vector.x), Real(vector.y), Real(vector.z)}, isList(true) {}

TermValue::TermValue(const std::vector<Surd> &list) : isList(true) {
  for (const Surd &number : list)
    entries.emplace_back(Real(number));
}

TermValue TermValue::list(std::vector<Polynomial> entries) {
  TermValue value;
  value.entries = std::move(entries);
  value.isList = true;
  return value;
}

std::optional<Real> TermValue::number() const {
  return isList || entries.empty() ? std::nullopt : entries.front().number();
}

bool TermValue::hasUnknowns() const {
  return std::any_of(entries.begin(), entries.end(),
                     [](const Polynomial &each) { return each.hasUnknowns(); });
}

std::optional<bool> areEqual(const TermValue &a, const TermValue &b) {
  if (a.isList != b.isList || a.entries.size() != b.entries.size())
    return false;
  std::optional<bool> all = true;
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    const auto same = areAllZero((a.entries[i] - b.entries[i]).summands());
    if (same == false)
      return false;
    if (!same)
      all.reset();
  }
  return all;
}

} // namespace halfspace
