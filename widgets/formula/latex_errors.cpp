#include "widgets/formula/latex_errors.h"

#include "lessons/words.h"

#include <string>

namespace halfspace::math {

void failStray(const Token &token) {
  if (token.is('}'))
    throw ReadError{token.column, halfspace::words("This `}` has no `{`.")};
  if (token.is('&'))
    throw ReadError{token.column, halfspace::words("`&` can stand only in a table.")};
  if (token.is('$'))
    throw ReadError{token.column, halfspace::words("`$` cannot stand inside a formula.")};
  if (token.isCommand("right"))
    throw ReadError{token.column, halfspace::words("This `\\right` has no `\\left`.")};
  if (token.isCommand("end"))
    throw ReadError{token.column, halfspace::words("This `\\end` has no `\\begin`.")};
  throw ReadError{token.column,
                  halfspace::words("`{command}` cannot stand here.", {{"command", sourceOf(token)}})};
}

void failUnclosed(TokenStream &tokens, std::size_t column, std::string_view opener, std::string_view closer) {
  const Token &here = tokens.peekMath();
  const bool closesOther = here.is('}') || here.isCommand("right") || here.isCommand("end");
  if (here.isEnd() || closesOther)
    throw ReadError{column,
                    halfspace::words("A `{closer}` is missing for this `{opener}`.",
                                     {{"closer", std::string(closer)}, {"opener", std::string(opener)}})};
  failStray(here);
}

} // namespace halfspace::math
