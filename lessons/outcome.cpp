#include "lessons/outcome.h"

namespace halfspace {
namespace {

Surd exactNumber(const Polynomial &entry) {
  const Real *number = entry.number();
  return number && number->exact() ? *number->exact() : Surd(0);
}

} // namespace

std::optional<Term> termOf(const Value &value) {
  if (const auto *number = std::get_if<Surd>(&value))
    return *number;
  if (const auto *index = std::get_if<int>(&value))
    return *index;
  const auto *numbers = std::get_if<std::vector<Surd>>(&value);
  return numbers ? std::optional(list({numbers->begin(), numbers->end()})) : std::nullopt;
}

NamedValue listed(std::string name, const Term &term) {
  const TermValue value = term->value.value_or(Real(0));
  NamedValue listed{std::move(name), term, Surd(0)};
  if (!value.isList) {
    listed.value = exactNumber(value.entries.at(0));
    return listed;
  }
  std::vector<Surd> entries;
  for (const Polynomial &entry : value.entries)
    entries.push_back(exactNumber(entry));
  listed.value = std::move(entries);
  return listed;
}

} // namespace halfspace
