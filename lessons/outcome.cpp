#include "lessons/outcome.h"

#include "lessons/term/latex.h"

namespace halfspace {
namespace {

Surd exactNumber(const Polynomial &entry) {
  const Real *number = entry.number();
  return number && number->exact() ? *number->exact() : Surd(0);
}

} // namespace

NamedValue listed(std::string name, const Term &term) {
  const TermValue value = term->value.value_or(Real(0));
  NamedValue listed{std::move(name), latexOf(term, LatexMarks::With), Surd(0)};
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
