#include "lessons/term/among_words.h"

#include "lessons/term/written.h"

#include <memory>

namespace halfspace {

Term amongWords(const Term &term) {
  if (!showsRounded(term))
    return term;
  auto node = std::make_shared<TermNode>(*term);
  if (term->kind == TermKind::Number)
    node->parts = {rounded(toDouble(*numberOf(term)), digitsAmongWords)};
  else
    for (Term &part : node->parts)
      part = amongWords(part);
  return Term(std::move(node));
}

} // namespace halfspace
