#include "lessons/construction/parts/expansion.h"

#include "lessons/construction/parts/worked_lines.h"
#include "lessons/term/rewrite.h"

namespace halfspace {

WorkingLine expansionLine(const Term &letter, const std::vector<Term> &vectors, std::size_t column,
                          std::string sentence) {
  const Term whole = determinant(vectors.size(), vectors);
  return asked(
      (letter == whole).then(columnsPutIn(whole)).then(expandedAlong(whole, column)).then(calculated(whole)),
      std::move(sentence));
}

} // namespace halfspace
