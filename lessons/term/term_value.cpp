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

bool isZero(const Real &number) { return number.exact() && number.exact()->sign() == 0; }

/// False where one is certainly unlike zero, nothing where it may be.
std::optional<bool> isAlwaysZero(const Polynomial &polynomial) {
  std::optional<bool> all = areEqual(polynomial.constant(), Real(0));
  for (const Polynomial::Summand &summand : polynomial.summands()) {
    const auto zero = areEqual(summand.factor, Real(0));
    if (all == false || zero == false)
      return false;
    if (!zero)
      all.reset();
  }
  return all;
}

} // namespace

Polynomial Polynomial::unknown(const std::string &letter) {
  Polynomial polynomial;
  polynomial.m_summands.push_back({{letter}, Real(1)});
  return polynomial;
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
  negated.m_constant = -negated.m_constant;
  for (Summand &summand : negated.m_summands)
    summand.factor = -summand.factor;
  return negated;
}

Polynomial operator+(const Polynomial &a, const Polynomial &b) {
  Polynomial sum = a;
  sum.m_constant = sum.m_constant + b.m_constant;
  for (const Polynomial::Summand &summand : b.m_summands)
    sum.add(summand.monomial, summand.factor);
  return sum;
}

Polynomial operator*(const Polynomial &a, const Polynomial &b) {
  Polynomial all = a.m_constant * b.m_constant;
  for (const Polynomial::Summand &left : a.m_summands) {
    all.add(left.monomial, left.factor * b.m_constant);
    for (const Polynomial::Summand &right : b.m_summands)
      all.add(product(left.monomial, right.monomial), left.factor * right.factor);
  }
  for (const Polynomial::Summand &right : b.m_summands)
    all.add(right.monomial, a.m_constant * right.factor);
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

bool isExact(const Polynomial &value) {
  return value.constant().exact() &&
         std::all_of(value.summands().begin(), value.summands().end(),
                     [](const Polynomial::Summand &each) { return each.factor.exact(); });
}

bool isExact(const TermValue &value) {
  return std::all_of(value.entries.begin(), value.entries.end(),
                     [](const Polynomial &entry) { return isExact(entry); });
}

std::optional<std::vector<Surd>> exactNumbers(const TermValue &value) {
  std::vector<Surd> numbers;
  for (const Polynomial &entry : value.entries) {
    const Real *number = entry.number();
    if (!number || !number->exact())
      return {};
    numbers.push_back(*number->exact());
  }
  return numbers;
}

std::optional<bool> areEqual(const TermValue &a, const TermValue &b) {
  if (a.isList != b.isList || a.entries.size() != b.entries.size())
    return false;
  std::optional<bool> all = true;
  for (std::size_t i = 0; i < a.entries.size(); ++i) {
    const auto same = a.entries[i].hasUnknowns() || b.entries[i].hasUnknowns()
                          ? isAlwaysZero(a.entries[i] - b.entries[i])
                          : areEqual(a.entries[i].constant(), b.entries[i].constant());
    if (same == false)
      return false;
    if (!same)
      all.reset();
  }
  return all;
}

} // namespace halfspace
