#include "lessons/words.h"
#include "widgets/formula/latex_symbols.h"
#include "widgets/formula/nesting.h"

#include <utility>

namespace halfspace::math {
namespace {

constexpr char32_t openingQuote = 0x2018;
constexpr char32_t closingQuote = 0x2019;

/// What TeX's typists write for a character that keyboards lack.
char32_t textCharacter(char32_t typed) {
  if (typed == '`')
    return openingQuote;
  if (typed == '\'')
    return closingQuote;
  return typed == '~' ? ' ' : typed;
}

} // namespace

void LatexReader::readText(Row &row, const Command &command) {
  Row content = readWords(command.alphabet);
  if (content.size() == 1)
    row.push_back(std::move(content.front()));
  else
    add(row, group(std::move(content)));
}

void LatexReader::readOperatorName(Row &row, const Command &command) {
  const bool hasLimits = m_tokens.takeIf('*');
  Row content = readWords(command.alphabet);
  Node name = content.size() == 1 ? std::move(content.front()) : group(std::move(content));
  name.atomClass = AtomClass::Op;
  name.scriptPlace = hasLimits ? ScriptPlace::LimitsInDisplay : ScriptPlace::Beside;
  add(row, std::move(name));
}

void LatexReader::readTag(Row &row, const Command &command) {
  // Its place in LaTeX is the page's margin, which a formula does not know.
  constexpr double roomBefore = 2;
  m_tokens.takeIf('*');
  Row content = readWords(command.alphabet);
  add(row, space(roomBefore));
  add(row, symbol('(', AtomClass::Open));
  detail::append(row, std::move(content));
  add(row, symbol(')', AtomClass::Close));
}

Row LatexReader::readWords(Alphabet alphabet) {
  const std::size_t column = m_column;
  if (!m_tokens.peekMath().is('{'))
    throw ReadError{column, halfspace::words("The words are missing: put them into `{}`.")};
  const Token open = m_tokens.take();
  const bool inOption = std::exchange(m_inOption, false);
  Row row;
  std::string words;
  readWordsInto(row, words, alphabet, open.column);
  flushWords(row, words, alphabet);
  m_inOption = inOption;
  return row;
}

void LatexReader::flushWords(Row &row, std::string &words, Alphabet alphabet) {
  if (!words.empty())
    add(row, math::words(std::exchange(words, {}), alphabet));
}

void LatexReader::readWordsInto(Row &row, std::string &words, Alphabet alphabet, std::size_t column) {
  const Nesting nesting(*this);
  while (!m_tokens.peek().is('}')) {
    const Token &next = m_tokens.peek();
    if (next.isEnd())
      throw ReadError{column, halfspace::words("A `}` is missing for this `{`.")};
    if (next.kind == Token::Kind::Command) {
      readTextCommand(row, words, alphabet);
      continue;
    }
    const Token token = m_tokens.take();
    if (token.is('{')) {
      readWordsInto(row, words, alphabet, token.column);
    } else if (token.is('$')) {
      flushWords(row, words, alphabet);
      readFormulaInText(row, token.column);
    } else {
      appendUtf8(words, textCharacter(token.character));
    }
  }
  m_tokens.take();
}

void LatexReader::readFormulaInText(Row &row, std::size_t column) {
  const auto alphabet = std::exchange(m_alphabet, std::nullopt);
  Row formula = readRow();
  m_alphabet = alphabet;
  if (!m_tokens.takeIf('$'))
    failUnclosed(column, "$", "$");
  add(row, {Group{std::move(formula), true}});
}

void LatexReader::readTextCommand(Row &row, std::string &words, Alphabet alphabet) {
  const Token token = m_tokens.take();
  const SymbolCommand *symbol = symbolNamed(token.name);
  if (symbol && symbol->character < 0x80) {
    appendUtf8(words, symbol->character);
    return;
  }
  flushWords(row, words, alphabet);
  readCommand(row, token);
}

} // namespace halfspace::math
