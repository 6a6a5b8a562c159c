#include "lessons/construction/outcome.h"

namespace halfspace {
std::optional<Term> termOf(const Value &value) {
  if (const auto *number = std::get_if<Surd>(&value))
    return *number;
  if (const auto *index = std::get_if<int>(&value))
    return *index;
  const auto *numbers = std::get_if<std::vector<Surd>>(&value);
  return numbers ? std::optional(list({numbers->begin(), numbers->end()})) : std::nullopt;
}

NamedValue listed(std::string name, const Term &term) {
  std::vector<Surd> numbers = exactNumbers(term->value.value()).value();
  if (term->value->isList)
    return {std::move(name), term, std::move(numbers)};
  return {std::move(name), term, std::move(numbers.front())};
}

} // namespace halfspace
