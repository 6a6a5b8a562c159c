#include "lessons/words.h"
#include "widgets/formula/latex_symbols.h"
#include "widgets/formula/nesting.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace::math {
namespace {

/// TeX's space between words, as `~` and `\ ` give it.
constexpr double wordSpace = 1.0 / 3;

/// What ends a row, apart from a closing bracket or the source's end.
constexpr std::array<std::string_view, 6> rowEnds{"\\", "cr", "end", "right", "hline", "tabularnewline"};

bool isCombining(char32_t c) { return (c >= 0x300 && c < 0x370) || (c >= 0x20D0 && c < 0x2100); }

bool isGreek(char32_t c) { return (c >= 0x391 && c <= 0x3C9) || (c >= 0x3D1 && c <= 0x3F5); }

bool isGreekCapital(char32_t c) { return c >= 0x391 && c <= 0x3A9; }

bool isControl(char32_t c) { return c < 0x20 || (c >= 0x7F && c < 0xA0); }

/// ∑ typed directly; null: no large operator.
const Command *largeOperatorOf(char32_t character) {
  if (character < 0x2000)
    return nullptr;
  const auto all = commands();
  const auto found = std::find_if(all.begin(), all.end(), [character](const Command &command) {
    return command.read == &LatexReader::readLargeOperator && command.character == character;
  });
  return found == all.end() ? nullptr : &*found;
}

bool isSingleSymbol(const Row &row) {
  return row.size() == 1 && std::holds_alternative<Symbol>(row.front().content);
}

/// What a script may not be attached to.
bool isNoAtom(const Node &node) {
  return std::holds_alternative<Space>(node.content) || std::holds_alternative<StyleSwitch>(node.content);
}

} // namespace

std::variant<Row, ReadError> readLatex(std::string_view latex, const Macros &macros) {
  if (latex.size() > longestLatex)
    return ReadError{1, halfspace::words("This formula is too long.")};
  try {
    return LatexReader(latex, macros).formula();
  } catch (ReadError &error) {
    return std::move(error);
  }
}

Row LatexReader::formula() {
  Table table;
  table.kind = TableKind::Aligned;
  table.columns = {Align::Right, Align::Left};
  readTableRows(table);
  if (const Token &rest = m_tokens.peekMath(); !rest.isEnd())
    failStray(rest);
  if (table.rows.empty())
    return {};
  if (table.rows.size() == 1 && table.rows.front().cells.size() == 1)
    return std::move(table.rows.front().cells.front());
  if (std::all_of(table.rows.begin(), table.rows.end(),
                  [](const TableRow &row) { return row.cells.size() == 1; })) {
    table.kind = TableKind::Gathered;
    table.columns = {Align::Center};
  }
  return row(math::table(std::move(table)));
}

void LatexReader::failStray(const Token &token) const {
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

void LatexReader::failUnclosed(std::size_t column, std::string_view opener, std::string_view closer) {
  const Token &here = m_tokens.peekMath();
  const bool closesOther = here.is('}') || here.isCommand("right") || here.isCommand("end");
  if (here.isEnd() || closesOther)
    throw ReadError{column,
                    halfspace::words("A `{closer}` is missing for this `{opener}`.",
                                     {{"closer", std::string(closer)}, {"opener", std::string(opener)}})};
  failStray(here);
}

void LatexReader::countNode() {
  if (++m_nodes > mostNodes)
    throw ReadError{m_tokens.peek().column, halfspace::words("This formula is too long.")};
}

void LatexReader::add(Row &row, Node node) {
  countNode();
  row.push_back(std::move(node));
}

bool LatexReader::atRowEnd() {
  const Token &token = m_tokens.peekMath();
  if (token.kind == Token::Kind::Command)
    return std::find(rowEnds.begin(), rowEnds.end(), token.name) != rowEnds.end();
  return token.isEnd() || token.is('}') || token.is('&') || token.is('$') || (m_inOption && token.is(']'));
}

Row LatexReader::readRow() {
  Row row;
  readRowInto(row);
  return row;
}

void LatexReader::readRowInto(Row &row) {
  const Nesting nesting(*this);
  const auto alphabet = m_alphabet;
  while (!atRowEnd())
    readScriptedAtom(row);
  m_alphabet = alphabet;
}

Row LatexReader::readGroup(std::size_t column) {
  const bool inOption = std::exchange(m_inOption, false);
  Row inside = readRow();
  m_inOption = inOption;
  if (!m_tokens.takeIf('}'))
    failUnclosed(column, "{", "}");
  return inside;
}

Row LatexReader::readArgument() {
  const Nesting nesting(*this);
  if (m_tokens.peekMath().is('{'))
    return readGroup(m_tokens.take().column);
  if (atRowEnd())
    throw ReadError{m_tokens.peek().column, halfspace::words("An argument is missing here.")};
  Row one;
  readAtom(one);
  return one;
}

std::optional<Row> LatexReader::readOption() {
  if (!m_tokens.peekMath().is('['))
    return std::nullopt;
  const std::size_t column = m_tokens.take().column;
  const bool inOption = std::exchange(m_inOption, true);
  Row inside = readRow();
  m_inOption = inOption;
  if (!m_tokens.takeIf(']'))
    failUnclosed(column, "[", "]");
  return inside;
}

bool LatexReader::atScript() {
  const Token &token = m_tokens.peekMath();
  if (token.kind != Token::Kind::Character)
    return false;
  return token.is('^') || token.is('_') || token.is('\'') || typedScript(token.character).has_value();
}

void LatexReader::readScriptedAtom(Row &row) {
  if (!atScript())
    readAtom(row);
  readScripts(row);
}

void LatexReader::readScripts(Row &row) {
  while (m_tokens.peekMath().isCommand("limits") || m_tokens.peekMath().isCommand("nolimits")) {
    const Token token = m_tokens.take();
    if (row.empty())
      throw ReadError{token.column, halfspace::words("`{command}` has nothing to stand behind.",
                                                     {{"command", sourceOf(token)}})};
    row.back().scriptPlace = token.name == "limits" ? ScriptPlace::Limits : ScriptPlace::Beside;
  }
  if (!atScript())
    return;
  Row above;
  Row below;
  while (atScript())
    readScript(above, below);
  countNode();
  if (row.empty() || isNoAtom(row.back()))
    add(row, group({}));
  row.back() = scripts(std::move(row.back()), std::move(above), std::move(below));
}

void LatexReader::readScript(Row &above, Row &below) {
  const Token token = m_tokens.peekMath();
  const auto typed = typedScript(token.character);
  const bool isBelow = token.is('_') || (typed && !typed->isAbove);
  Row &script = isBelow ? below : above;
  if (!script.empty() && !token.is('\''))
    throw ReadError{
        token.column,
        isBelow ? halfspace::words("There are two subscripts: put the first with its base into `{}`.")
                : halfspace::words("There are two superscripts: put the first with its base into `{}`.")};
  if (token.is('\'')) {
    detail::append(script, readPrimes());
    if (m_tokens.takeIf('^'))
      detail::append(script, readArgument());
    return;
  }
  if (typed) {
    script = readTypedScript(typed->isAbove);
    return;
  }
  m_tokens.take();
  script = readArgument();
  // Empty braces are a script too, so that a second one is seen.
  if (script.empty())
    add(script, group({}));
}

Row LatexReader::readPrimes() {
  // ′ ″ ‴ ⁗ have characters of their own; what is left over begins anew.
  constexpr std::array<char32_t, 4> primes{U'′', U'″', U'‴', U'⁗'};
  std::size_t count = 0;
  while (m_tokens.takeIf('\''))
    ++count;
  Row row;
  for (; count > 0; count -= std::min(count, primes.size()))
    add(row, symbol(primes[std::min(count, primes.size()) - 1]));
  return row;
}

Row LatexReader::readTypedScript(bool isAbove) {
  Row row;
  for (auto typed = typedScript(m_tokens.peek().character); typed && typed->isAbove == isAbove;
       typed = typedScript(m_tokens.peek().character)) {
    m_tokens.take();
    readPlainCharacter(row, typed->character);
  }
  return row;
}

void LatexReader::readAtom(Row &row) {
  const Token token = m_tokens.takeMath();
  if (token.kind == Token::Kind::Command)
    readCommand(row, token);
  else if (token.is('{'))
    readBraces(row, token);
  else
    readCharacter(row, token);
}

void LatexReader::readBraces(Row &row, const Token &open) {
  Row inside = readGroup(open.column);
  // A single symbol stays one, for kerning and scripts, but it is ordinary then.
  if (isSingleSymbol(inside) && !std::get<Symbol>(inside.front().content).isLarge) {
    row.push_back(std::move(inside.front()));
    row.back().atomClass = AtomClass::Ord;
    return;
  }
  add(row, group(std::move(inside)));
}

void LatexReader::readCommand(Row &row, const Token &token) {
  m_column = token.column;
  if (const Command *command = commandNamed(token.name)) {
    (this->*command->read)(row, *command);
    return;
  }
  const SymbolCommand *found = symbolNamed(token.name);
  if (!found)
    throw ReadError{token.column,
                    halfspace::words("`{command}` is unknown.", {{"command", sourceOf(token)}})};
  add(row, symbol(isGreek(found->character) ? inCurrentAlphabet(found->character) : found->character,
                  found->atomClass));
}

char32_t LatexReader::inCurrentAlphabet(char32_t letter) const {
  const bool isBold = m_alphabet == Alphabet::Bold || m_alphabet == Alphabet::BoldItalic;
  if (isAsciiDigit(letter))
    return m_alphabet ? inAlphabet(letter, *m_alphabet) : letter;
  if (!isGreek(letter))
    return inAlphabet(letter, m_alphabet.value_or(Alphabet::Italic));
  // Greek letters are upright or italic by their size, and take on weight alone.
  if (isGreekCapital(letter))
    return isBold ? inAlphabet(letter, *m_alphabet) : letter;
  return inAlphabet(letter, isBold ? *m_alphabet : Alphabet::Italic);
}

void LatexReader::readCharacter(Row &row, const Token &token) {
  const char32_t character = token.character;
  if (token.is('#') || token.is('&') || token.is('$') || token.is('}') || token.is('^') || token.is('_'))
    failStray(token);
  if (isControl(character))
    throw ReadError{token.column, halfspace::words("This character cannot be shown.")};
  if (const Command *command = largeOperatorOf(character)) {
    readLargeOperator(row, *command);
  } else if (isCombining(character) && !row.empty()) {
    countNode();
    row.back() = accent(character, math::row(std::move(row.back())));
  } else if (token.is('~') || character == 0xA0) {
    add(row, space(wordSpace));
  } else {
    readPlainCharacter(row, character);
  }
}

void LatexReader::readPlainCharacter(Row &row, char32_t character) {
  if (isAsciiLetter(character) || isAsciiDigit(character) || isGreek(character)) {
    add(row, symbol(inCurrentAlphabet(character)));
    return;
  }
  const TypedSymbol typed = typedSymbol(character);
  add(row, symbol(typed.character, typed.atomClass));
}

} // namespace halfspace::math
