#include "widgets/formula/latex_reader.h"

#include "lessons/term/greek.h"
#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/formula/latex_command_readers.h"
#include "widgets/formula/latex_errors.h"
#include "widgets/formula/latex_symbols.h"
#include "widgets/formula/read_latex_scripts.h"

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
    return command.read == &readLargeOperator && command.character == character;
  });
  return found == all.end() ? nullptr : &*found;
}

bool isSingleSymbol(const Row &row) {
  return row.size() == 1 && std::holds_alternative<Symbol>(row.front().content);
}

} // namespace

void LatexReader::countNode() {
  if (++m_nodes > mostNodes)
    throw ReadError{m_tokens.peek().column, halfspace::words("This formula is too long.")};
}

void LatexReader::add(Row &row, Node node) {
  countNode();
  row.push_back(std::move(node));
}

void LatexReader::addGroup(Row &row, Row content) {
  if (content.size() == 1)
    row.push_back(std::move(content.front()));
  else
    add(row, group(std::move(content)));
}

bool LatexReader::atRowEnd() {
  const Token &token = m_tokens.peekMath();
  if (token.kind == Token::Kind::Command)
    return std::find(rowEnds.begin(), rowEnds.end(), token.name) != rowEnds.end();
  return token.isEnd() || token.is('}') || token.is('&') || token.is('$') ||
         (m_surroundings.inOption && token.is(']'));
}

Row LatexReader::readRow() {
  const Nesting nesting = nested();
  // An alphabet that is switched to inside ends with the row.
  const Within alphabet(m_surroundings.alphabet, m_surroundings.alphabet);
  Row row;
  while (!atRowEnd())
    readScriptedAtom(row);
  return row;
}

Row LatexReader::readGroup(std::size_t column) {
  const Within option(m_surroundings.inOption, false);
  Row inside = readRow();
  if (!m_tokens.takeIf('}'))
    failUnclosed(m_tokens, column, "{", "}");
  return inside;
}

Row LatexReader::readArgument() {
  const Nesting nesting = nested();
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
  const Within option(m_surroundings.inOption, true);
  Row inside = readRow();
  if (!m_tokens.takeIf(']'))
    failUnclosed(m_tokens, column, "[", "]");
  return inside;
}

void LatexReader::readScriptedAtom(Row &row) {
  if (!isAtScript(m_tokens))
    readAtom(row);
  readScripts(*this, row);
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
  if (const Command *command = commandNamed(token.name)) {
    command->read(*this, row, {*command, token.column});
    return;
  }
  if (const GreekLetter *greek = greekCommand(token.name)) {
    readPlainCharacter(row, firstCharacter(greek->letter).code);
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
  const std::optional<Alphabet> &alphabet = m_surroundings.alphabet;
  const bool isBold = alphabet == Alphabet::Bold || alphabet == Alphabet::BoldItalic;
  if (isAsciiDigit(letter))
    return alphabet ? inAlphabet(letter, *alphabet) : letter;
  if (!isGreek(letter))
    return inAlphabet(letter, alphabet.value_or(Alphabet::Italic));
  // Greek letters are upright or italic by their size, and take on weight alone.
  if (isGreekCapital(letter))
    return isBold ? inAlphabet(letter, *alphabet) : letter;
  return inAlphabet(letter, isBold ? *alphabet : Alphabet::Italic);
}

void LatexReader::readCharacter(Row &row, const Token &token) {
  const char32_t character = token.character;
  if (token.is('#') || token.is('&') || token.is('$') || token.is('}') || token.is('^') || token.is('_'))
    failStray(token);
  if (isControl(character))
    throw ReadError{token.column, halfspace::words("This character cannot be shown.")};
  if (const Command *command = largeOperatorOf(character)) {
    readLargeOperator(*this, row, {*command, token.column});
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
