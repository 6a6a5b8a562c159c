#include "lessons/term/operate.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace halfspace {
namespace {

using Found = std::optional<TermValue>;
using Parts = std::vector<Term>;

const TermValue &valueOf(const Term &part) { return *part->value; }

Found sumOf(const Parts &summands) {
  TermValue sum = valueOf(summands.front());
  for (auto summand = summands.begin() + 1; summand != summands.end(); ++summand) {
    const TermValue &next = valueOf(*summand);
    if (next.isList != sum.isList || next.entries.size() != sum.entries.size())
      return {};
    for (std::size_t i = 0; i < sum.entries.size(); ++i)
      sum.entries[i] = sum.entries[i] + next.entries[i];
  }
  return sum;
}

TermValue scaled(TermValue value, const Polynomial &factor) {
  for (Polynomial &entry : value.entries)
    entry = entry * factor;
  return value;
}

Found productOf(const Parts &factors) {
  TermValue product = valueOf(factors.front());
  for (auto factor = factors.begin() + 1; factor != factors.end(); ++factor) {
    const TermValue &next = valueOf(*factor);
    if (next.isList && product.isList)
      return {};
    product = next.isList ? scaled(next, product.entries.front())
                          : scaled(std::move(product), next.entries.front());
  }
  return product;
}

Found dotOf(const TermValue &a, const TermValue &b) {
  if (!a.isList || !b.isList || a.entries.size() != b.entries.size())
    return {};
  Polynomial sum;
  for (std::size_t i = 0; i < a.entries.size(); ++i)
    sum = sum + a.entries[i] * b.entries[i];
  return sum;
}

Found crossOf(const TermValue &left, const TermValue &right) {
  const auto &a = left.entries;
  const auto &b = right.entries;
  if (!left.isList || !right.isList || a.size() != 3 || b.size() != 3)
    return {};
  return TermValue::list({a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
}

Found quotientOf(const TermValue &dividend, const TermValue &divisor) {
  const Real *by = divisor.number();
  const auto reciprocal = by ? quotient(Real(1), *by) : std::nullopt;
  return reciprocal ? Found(scaled(dividend, *reciprocal)) : std::nullopt;
}

Found powerOf(const TermValue &base, const TermValue &exponent) {
  const Real *number = exponent.number();
  if (base.isList || !number)
    return {};
  const int times = static_cast<int>(toDouble(*number));
  Polynomial power = Real(1);
  for (int i = 0; i < std::abs(times); ++i)
    power = power * base.entries.front();
  return times < 0 ? quotientOf(Real(1), power) : Found(power);
}

Found rootOf(const TermValue &square) {
  const Real *number = square.number();
  const auto root = number ? squareRoot(*number) : std::nullopt;
  return root ? Found(*root) : std::nullopt;
}

Found normOf(const TermValue &value) {
  if (value.isList) {
    const auto square = dotOf(value, value);
    return square ? rootOf(*square) : std::nullopt;
  }
  const Real *number = value.number();
  const auto side = number ? sign(*number) : std::nullopt;
  return side ? Found(*side < 0 ? -*number : *number) : std::nullopt;
}

/// By the first row, minor by minor: determinants of the notes have three rows.
Polynomial determinantOf(const std::vector<Polynomial> &entries, std::size_t size) {
  if (size == 1)
    return entries.front();
  Polynomial sum;
  for (std::size_t column = 0; column < size; ++column) {
    std::vector<Polynomial> minor;
    for (std::size_t i = size; i < size * size; ++i)
      if (i % size != column)
        minor.push_back(entries[i]);
    const Polynomial part = entries[column] * determinantOf(minor, size - 1);
    sum = column % 2 == 0 ? sum + part : sum - part;
  }
  return sum;
}

/// The entries one after the other; nothing where one is a list itself.
std::optional<std::vector<Polynomial>> entriesOf(const Parts &parts) {
  std::vector<Polynomial> entries;
  entries.reserve(parts.size());
  for (const Term &part : parts) {
    if (valueOf(part).isList)
      return {};
    entries.push_back(valueOf(part).entries.front());
  }
  return entries;
}

/// The rows of numbers, one after the other, of vectors that are columns; nothing where they are no such.
std::optional<std::vector<Polynomial>> rowsOf(const Parts &columns) {
  std::vector<Polynomial> entries;
  for (std::size_t row = 0; row < columns.size(); ++row)
    for (const Term &column : columns) {
      const TermValue &value = valueOf(column);
      if (!value.isList || value.entries.size() != columns.size())
        return {};
      entries.push_back(value.entries[row]);
    }
  return entries;
}

Found determinantOf(const Parts &parts, std::size_t columns) {
  const auto entries = parts.size() == columns && columns > 1 ? rowsOf(parts) : entriesOf(parts);
  if (!entries || columns == 0 || entries->size() != columns * columns)
    return {};
  return determinantOf(*entries, columns);
}

Found permutedOf(const Parts &parts) {
  const Found first = dotOf(valueOf(parts[0]), valueOf(parts[3]));
  const Found second = dotOf(valueOf(parts[2]), valueOf(parts[1]));
  return first && second ? Found(first->entries.front() + second->entries.front()) : std::nullopt;
}

Found operated(TermKind kind, const Parts &parts, std::size_t columns) {
  switch (kind) {
  case TermKind::Negation:
    return scaled(valueOf(parts[0]), Real(-1));
  case TermKind::Sum:
    return sumOf(parts);
  case TermKind::Product:
    return productOf(parts);
  case TermKind::Dot:
    return dotOf(valueOf(parts[0]), valueOf(parts[1]));
  case TermKind::Cross:
    return crossOf(valueOf(parts[0]), valueOf(parts[1]));
  case TermKind::Quotient:
    return quotientOf(valueOf(parts[0]), valueOf(parts[1]));
  case TermKind::Power:
    return powerOf(valueOf(parts[0]), valueOf(parts[1]));
  case TermKind::Root:
    return rootOf(valueOf(parts[0]));
  case TermKind::Norm:
    return normOf(valueOf(parts[0]));
  case TermKind::List:
  case TermKind::Matrix: {
    auto entries = entriesOf(parts);
    return entries ? Found(TermValue::list(std::move(*entries))) : std::nullopt;
  }
  case TermKind::Determinant:
    return determinantOf(parts, columns);
  case TermKind::Permuted:
    return permutedOf(parts);
  case TermKind::Digits:
  case TermKind::Number:
  case TermKind::Name:
  case TermKind::Unknown:
  case TermKind::Applied:
    break;
  }
  return {};
}

} // namespace

std::optional<TermValue> operate(TermKind kind, const std::vector<Term> &parts, std::size_t columns) {
  const bool haveValues = std::all_of(parts.begin(), parts.end(), [](const Term &part) {
    return part->value && !part->value->entries.empty();
  });
  return haveValues && !parts.empty() ? operated(kind, parts, columns) : std::nullopt;
}

} // namespace halfspace
