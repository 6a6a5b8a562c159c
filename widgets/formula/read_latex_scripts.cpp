#include "widgets/formula/read_latex_scripts.h"

#include "lessons/words.h"
#include "widgets/formula/latex_symbols.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace::math {
namespace {

/// What a script may not be attached to.
bool isNoAtom(const Node &node) {
  return std::holds_alternative<Space>(node.content) || std::holds_alternative<StyleSwitch>(node.content);
}

Row readPrimes(LatexReader &reader) {
  // ′ ″ ‴ ⁗ have characters of their own; what is left over begins anew.
  constexpr std::array<char32_t, 4> primes{U'′', U'″', U'‴', U'⁗'};
  std::size_t count = 0;
  while (reader.tokens().takeIf('\''))
    ++count;
  Row row;
  for (; count > 0; count -= std::min(count, primes.size()))
    reader.add(row, symbol(primes[std::min(count, primes.size()) - 1]));
  return row;
}

/// ²³ or ₀₁: those that stand on one side.
Row readTypedScript(LatexReader &reader, bool isAbove) {
  TokenStream &tokens = reader.tokens();
  Row row;
  for (auto typed = typedScript(tokens.peek().character); typed && typed->isAbove == isAbove;
       typed = typedScript(tokens.peek().character)) {
    tokens.take();
    reader.readPlainCharacter(row, typed->character);
  }
  return row;
}

void readScript(LatexReader &reader, Row &above, Row &below) {
  TokenStream &tokens = reader.tokens();
  const Token token = tokens.peekMath();
  const auto typed = typedScript(token.character);
  const bool isBelow = token.is('_') || (typed && !typed->isAbove);
  Row &script = isBelow ? below : above;
  if (!script.empty() && !token.is('\''))
    throw ReadError{
        token.column,
        isBelow ? halfspace::words("There are two subscripts: put the first with its base into `{}`.")
                : halfspace::words("There are two superscripts: put the first with its base into `{}`.")};
  if (token.is('\'')) {
    detail::append(script, readPrimes(reader));
    if (tokens.takeIf('^'))
      detail::append(script, reader.readArgument());
    return;
  }
  if (typed) {
    script = readTypedScript(reader, typed->isAbove);
    return;
  }
  tokens.take();
  script = reader.readArgument();
  // Empty braces are a script too, so that a second one is seen.
  if (script.empty())
    reader.add(script, group({}));
}

/// \limits and \nolimits
void readScriptPlaces(TokenStream &tokens, Row &row) {
  while (tokens.peekMath().isCommand("limits") || tokens.peekMath().isCommand("nolimits")) {
    const Token token = tokens.take();
    if (row.empty())
      throw ReadError{token.column, halfspace::words("`{command}` has nothing to stand behind.",
                                                     {{"command", sourceOf(token)}})};
    row.back().scriptPlace = token.name == "limits" ? ScriptPlace::Limits : ScriptPlace::Beside;
  }
}

} // namespace

bool isAtScript(TokenStream &tokens) {
  const Token &token = tokens.peekMath();
  if (token.kind != Token::Kind::Character)
    return false;
  return token.is('^') || token.is('_') || token.is('\'') || typedScript(token.character).has_value();
}

void readScripts(LatexReader &reader, Row &row) {
  readScriptPlaces(reader.tokens(), row);
  if (!isAtScript(reader.tokens()))
    return;
  Row above;
  Row below;
  while (isAtScript(reader.tokens()))
    readScript(reader, above, below);
  reader.countNode();
  if (row.empty() || isNoAtom(row.back()))
    reader.add(row, group({}));
  row.back() = scripts(std::move(row.back()), std::move(above), std::move(below));
}

} // namespace halfspace::math
