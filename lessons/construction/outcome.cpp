#include "lessons/construction/outcome.h"

#include "lessons/term/plain_text.h"

namespace halfspace {

std::string readName(const NamedValue &value) {
  if (const auto *term = std::get_if<Term>(&value.label))
    return plainText(*term);
  const auto *read = std::get_if<std::string>(&value.label);
  return read ? *read : std::string();
}

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
