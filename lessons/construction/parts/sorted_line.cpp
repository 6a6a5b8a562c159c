#include "lessons/construction/parts/sorted_line.h"

#include "lessons/construction/parts/components.h"
#include "lessons/construction/parts/worked_lines.h"
#include "lessons/term/rewrite.h"

#include <algorithm>

namespace halfspace {

WorkingLine sortedLine(std::vector<Term> terms, std::string sentence) {
  std::stable_sort(terms.begin(), terms.end(),
                   [](const Term &a, const Term &b) { return rationalOf(a) < rationalOf(b); });
  std::vector<Term> numbers;
  numbers.reserve(terms.size());
  for (const Term &term : terms) // a number that is written as one comes from nothing else
    numbers.push_back(term->kind == TermKind::Number ? term : calculated(term));
  // Rounded, two numbers may read alike that are not the same.
  for (std::size_t i = 1; i < terms.size(); ++i)
    if (readAlike(numbers[i - 1], numbers[i]) && rationalOf(terms[i - 1]) != rationalOf(terms[i]))
      return line(inOrder(std::move(terms)), std::move(sentence));
  return line({inOrder(std::move(terms)), inOrder(std::move(numbers))}, std::move(sentence));
}

} // namespace halfspace
