#include "lessons/term/rewrite.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

namespace halfspace {
namespace {

void appendUnknowns(std::vector<Term> &factors, const Polynomial::Monomial &monomial) {
  for (std::size_t i = 0; i < monomial.size();) {
    const auto same = static_cast<int>(std::count(monomial.begin(), monomial.end(), monomial[i]));
    factors.push_back(same == 1 ? unknown(monomial[i]) : power(unknown(monomial[i]), same));
    i += static_cast<std::size_t>(same);
  }
}

Real magnitudeOf(const Real &number) { return sign(number) == -1 ? -number : number; }

/// |factor|·x², without a factor 1.
Term magnitudeOf(const Polynomial::Summand &summand, const Term &origin) {
  const Real magnitude = magnitudeOf(summand.factor);
  std::vector<Term> factors;
  if (areEqual(magnitude, Real(1)) != true)
    factors.push_back(number(magnitude, origin));
  appendUnknowns(factors, summand.monomial);
  return factors.size() == 1 ? factors.front() : product(std::move(factors));
}

/// Where the number of a polynomial stands: 9t + 30 of an equation, 11 − t of a coordinate, which has a start
/// and goes on from there.
enum class NumberPlace : std::uint8_t { Last, First };

Term collected(const Polynomial &polynomial, const Term &origin, NumberPlace place) {
  if (const Real *constant = polynomial.number())
    return number(*constant, origin);
  std::vector<Term> summands;
  const auto append = [&](const Real &factor, const Term &magnitude) {
    summands.push_back(sign(factor) == -1 ? -magnitude : magnitude);
  };
  for (const Polynomial::Summand &summand : polynomial.summands())
    append(summand.factor, magnitudeOf(summand, origin));
  const Real &constant = polynomial.constant();
  if (areEqual(constant, Real(0)) != true)
    append(constant, number(magnitudeOf(constant), origin));
  if (place == NumberPlace::First)
    std::reverse(summands.begin(), summands.end());
  return summands.size() == 1 ? summands.front() : sum(std::move(summands));
}

/// The component of a coordinate, where the list or the number is one; that of a name which is one already.
std::optional<CoordinateSource> sourceOf(const Term &whole, std::size_t index) {
  std::optional<CoordinateSource> source = whole->source;
  if (source && !source->component)
    source->component = static_cast<int>(index);
  return source;
}

Term valueAsTerm(const TermValue &value, const Term &origin) {
  if (!value.isList) {
    const Real *constant = value.entries.front().number();
    return constant ? number(*constant, origin, sourceOf(origin, 0))
                    : collected(value.entries.front(), origin, NumberPlace::Last);
  }
  std::vector<Term> entries;
  entries.reserve(value.entries.size());
  for (std::size_t i = 0; i < value.entries.size(); ++i) {
    const Real *constant = value.entries[i].number();
    entries.push_back(constant ? number(*constant, origin, sourceOf(origin, i))
                               : collected(value.entries[i], origin, NumberPlace::First));
  }
  return list(std::move(entries));
}

/// Rewrites the parts. A sum in a sum becomes part of it.
template <class Rewriting> Term partsBy(Rewriting rewriting, const Term &term) {
  if (term->parts.empty() || term->kind == TermKind::Number || term->kind == TermKind::Applied)
    return term;
  std::vector<Term> parts;
  parts.reserve(term->parts.size());
  for (const Term &part : term->parts) {
    Term rewritten = rewriting(part);
    if (term->kind == TermKind::Sum && rewritten->kind == TermKind::Sum)
      parts.insert(parts.end(), rewritten->parts.begin(), rewritten->parts.end());
    else
      parts.push_back(std::move(rewritten));
  }
  return withParts(term, std::move(parts));
}

bool isNamed(const Term &term) { return term->kind == TermKind::Name || term->kind == TermKind::Applied; }

/// Whether "numbers put in" shows what comes of it, rather than how.
bool isOneNumber(const Term &term) {
  switch (term->kind) {
  case TermKind::Dot:
  case TermKind::Cross:
  case TermKind::Norm:
  case TermKind::Determinant:
  case TermKind::Permuted:
    return true;
  default:
    return isNamed(term);
  }
}

Term inserted(const Term &term) { return isOneNumber(term) ? calculated(term) : partsBy(inserted, term); }

bool isProductOfVectors(const Term &term) {
  return term->kind == TermKind::Dot || term->kind == TermKind::Cross;
}

/// Whether both factors of a product are lists of equally many numbers; for a cross product three.
bool areListsThatMatch(const Term &product) {
  const Term &a = product->parts[0];
  const Term &b = product->parts[1];
  return a->kind == TermKind::List && b->kind == TermKind::List && a->parts.size() == b->parts.size() &&
         (product->kind == TermKind::Dot || a->parts.size() == 3);
}

/// a₁b₁ + a₂b₂ + a₃b₃
Term summed(const Term &dot) {
  std::vector<Term> products;
  products.reserve(dot->parts[0]->parts.size());
  for (std::size_t i = 0; i < dot->parts[0]->parts.size(); ++i)
    products.push_back(product({dot->parts[0]->parts[i], dot->parts[1]->parts[i]}));
  return sum(std::move(products));
}

/// (a₂b₃ − a₃b₂, a₃b₁ − a₁b₃, a₁b₂ − a₂b₁)
Term crosswise(const Term &cross) {
  const std::vector<Term> &a = cross->parts[0]->parts;
  const std::vector<Term> &b = cross->parts[1]->parts;
  std::vector<Term> differences;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = (i + 1) % 3;
    const std::size_t last = (i + 2) % 3;
    differences.push_back(product({a[next], b[last]}) - product({a[last], b[next]}));
  }
  return list(std::move(differences));
}

/// Whether it is one row of vectors: its columns.
bool hasVectorsForColumns(const Term &determinant) {
  return determinant->columns > 1 && determinant->parts.size() == determinant->columns;
}

bool isZero(const Term &term) {
  const Real *value = numberOf(term);
  return value && areEqual(*value, Real(0)) == true;
}

/// A sum without the summands that are 0; 0 where nothing is left.
Term withoutZeros(const Term &term) {
  if (term->kind != TermKind::Sum)
    return term;
  std::vector<Term> left;
  std::copy_if(term->parts.begin(), term->parts.end(), std::back_inserter(left),
               [](const Term &part) { return !isZero(part); });
  if (left.empty())
    return term->parts.front();
  return left.size() == 1 ? left.front() : sum(std::move(left));
}

/// What is left of a determinant without a row and a column.
Term minorOf(const Term &determinant, std::size_t row, std::size_t column) {
  const std::size_t size = determinant->columns;
  std::vector<Term> left;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j)
      if (i != row && j != column)
        left.push_back(determinant->parts[i * size + j]);
  return size == 2 ? left.front() : halfspace::determinant(size - 1, std::move(left));
}

} // namespace

Term columnsPutIn(const Term &determinant) {
  if (!hasVectorsForColumns(determinant) || !determinant->value)
    return partsBy(calculated, determinant);
  const std::size_t size = determinant->columns;
  std::vector<Term> columns;
  for (const Term &vector : determinant->parts)
    columns.push_back(calculated(vector));
  std::vector<Term> entries;
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column)
      entries.push_back(columns[column]->parts[row].marked(determinant->parts[column]->mark));
  return halfspace::determinant(size, std::move(entries));
}

Term expandedAlong(const Term &determinant, std::size_t column) {
  Term square = columnsPutIn(determinant);
  const std::size_t size = square->columns;
  if (size < 2 || square->parts.size() != size * size)
    return square;
  std::vector<Term> summands;
  for (std::size_t row = 0; row < size; ++row) {
    const Term part = product({square->parts[row * size + column], minorOf(square, row, column)});
    summands.push_back((row + column) % 2 == 0 ? part : -part);
  }
  return sum(std::move(summands));
}

Term calculated(const Term &term) { return term->value ? valueAsTerm(*term->value, term) : term; }

Term multipleOf(const Term &factor, const Term &term) {
  const Real *value = numberOf(factor);
  if (!value)
    return factor * term;
  const Term scaled = number(magnitudeOf(*value), factor) * term;
  return sign(*value) == -1 ? -scaled : scaled;
}

Term namesPutIn(const Term &term) { return isNamed(term) ? calculated(term) : partsBy(namesPutIn, term); }

Term numbersPutIn(const Term &term) {
  if (term->kind == TermKind::Determinant)
    return columnsPutIn(term);
  return isOneNumber(term) && !isNamed(term) ? partsBy(calculated, term) : inserted(term);
}

Term multipliedOut(const Term &term) {
  if (isNamed(term))
    return calculated(term);
  if (term->kind == TermKind::Determinant)
    return expandedAlong(term, 0);
  Term rewritten = isProductOfVectors(term) ? partsBy(calculated, term) : partsBy(multipliedOut, term);
  if (!isProductOfVectors(rewritten) || !areListsThatMatch(rewritten))
    return rewritten;
  return rewritten->kind == TermKind::Dot ? summed(rewritten) : crosswise(rewritten);
}

Term distributed(const Term &term) {
  const bool isMultiple =
      term->kind == TermKind::Product && term->parts.size() == 2 && numberOf(term->parts.front());
  if (!isMultiple)
    return withoutZeros(partsBy(distributed, term));
  const Term &factor = term->parts[0];
  const Term &whole = term->parts[1];
  if (whole->kind != TermKind::Sum || isZero(factor))
    return calculated(term);
  std::vector<Term> summands;
  for (const Term &part : whole->parts)
    summands.push_back(calculated(factor * part));
  return sum(std::move(summands));
}

} // namespace halfspace
