#include "lessons/term/operations.h"

#include <algorithm>

namespace halfspace {
namespace {

constexpr int dimension = 3;
constexpr Operations ofDot{.multiplications = dimension, .additions = dimension - 1};
constexpr Operations ofCross{.multiplications = 2 * dimension, .additions = dimension};

/// Whether it is a vector or a point, even where it comes to nothing.
bool isVector(const Term &term) {
  switch (term->kind) {
  case TermKind::Cross:
    return true;
  case TermKind::Negation:
  case TermKind::Sum:
  case TermKind::Product:
  case TermKind::Quotient:
    return std::any_of(term->parts.begin(), term->parts.end(), isVector);
  default:
    return term->value && term->value->isList;
  }
}

/// By the cofactors of one column.
Operations ofDeterminant(int rows) {
  if (rows <= 1)
    return {};
  const Operations minor = ofDeterminant(rows - 1);
  return {.multiplications = rows * (minor.multiplications + 1),
          .additions = rows * minor.additions + rows - 1};
}

/// Of the term itself, without those of its parts.
Operations ownOperations(const Term &term) {
  const int parts = static_cast<int>(term->parts.size());
  const int numbers = isVector(term) ? dimension : 1;
  switch (term->kind) {
  case TermKind::Sum:
    return {.additions = (parts - 1) * numbers};
  case TermKind::Product: // the numbers first
    return {.multiplications = isVector(term) ? parts - 2 + dimension : parts - 1};
  case TermKind::Dot:
    return ofDot;
  case TermKind::Cross:
    return ofCross;
  case TermKind::Quotient:
    return {.divisions = numbers};
  case TermKind::Power:
    return {.multiplications = static_cast<int>(toDouble(*numberOf(term->parts[1]))) - 1};
  case TermKind::Root:
    return {.roots = 1};
  case TermKind::Norm:
    return isVector(term->parts[0]) ? ofDot + Operations{.roots = 1} : Operations{};
  case TermKind::Determinant:
    return ofDeterminant(static_cast<int>(term->columns));
  case TermKind::Permuted:
    return ofDot + ofDot + Operations{.additions = 1};
  default:
    return {};
  }
}

} // namespace

Operations &Operations::operator+=(const Operations &other) {
  multiplications += other.multiplications;
  additions += other.additions;
  divisions += other.divisions;
  roots += other.roots;
  return *this;
}

Operations OperationCounter::add(const Term &formula) {
  if (formula->parts.empty() || formula->kind == TermKind::Number)
    return {};
  if (std::any_of(m_kept.begin(), m_kept.end(), [&](const Term &kept) { return readAlike(kept, formula); }))
    return {};
  Operations all = ownOperations(formula);
  for (const Term &part : formula->parts)
    all += add(part);
  m_kept.push_back(formula);
  return all;
}

} // namespace halfspace
