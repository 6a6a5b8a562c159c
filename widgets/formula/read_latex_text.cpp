// The commands of words.
#include "lessons/words.h"
#include "widgets/formula/latex_command_readers.h"
#include "widgets/formula/latex_errors.h"
#include "widgets/formula/latex_reader.h"
#include "widgets/formula/latex_symbols.h"

#include <optional>
#include <string>
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

/// Words with formulas among them, from one alphabet.
class TextReader {
public:
  TextReader(LatexReader &reader, Alphabet alphabet) : m_reader(reader), m_alphabet(alphabet) {}

  /// What stands between the braces that are next. `column` is the command's.
  [[nodiscard]] Row read(std::size_t column);

private:
  /// Behind a `{` at `column`, up to its `}`. An alphabet that is switched to inside ends with it.
  void readGroup(std::size_t column);
  void readCommand();
  void readFormula(std::size_t column);
  /// The alphabet of the words that follow.
  void switchTo(Alphabet alphabet);
  /// The words so far become a part of the row.
  void flush();

  LatexReader &m_reader;
  Alphabet m_alphabet;
  Row m_row;
  std::string m_words;
};

Row TextReader::read(std::size_t column) {
  if (!m_reader.tokens().peekMath().is('{'))
    throw ReadError{column, halfspace::words("The words are missing: put them into `{}`.")};
  const Token open = m_reader.tokens().take();
  const Within option(m_reader.surroundings().inOption, false);
  readGroup(open.column);
  flush();
  return std::move(m_row);
}

void TextReader::flush() {
  if (!m_words.empty())
    m_reader.add(m_row, math::words(std::exchange(m_words, {}), m_alphabet));
}

void TextReader::readGroup(std::size_t column) {
  const Nesting nesting = m_reader.nested();
  const Within ofSymbols(m_reader.surroundings().alphabet, m_reader.surroundings().alphabet);
  const Alphabet outside = m_alphabet;
  TokenStream &tokens = m_reader.tokens();
  while (!tokens.peek().is('}')) {
    const Token &next = tokens.peek();
    if (next.isEnd())
      throw ReadError{column, halfspace::words("A `}` is missing for this `{`.")};
    if (next.kind == Token::Kind::Command) {
      readCommand();
      continue;
    }
    const Token token = tokens.take();
    if (token.is('{')) {
      readGroup(token.column);
    } else if (token.is('$')) {
      flush();
      readFormula(token.column);
    } else {
      appendUtf8(m_words, textCharacter(token.character));
    }
  }
  tokens.take();
  switchTo(outside);
}

void TextReader::switchTo(Alphabet alphabet) {
  if (alphabet != m_alphabet)
    flush();
  m_alphabet = alphabet;
}

void TextReader::readFormula(std::size_t column) {
  const Within alphabet(m_reader.surroundings().alphabet, std::optional<Alphabet>());
  Row formula = m_reader.readRow();
  if (!m_reader.tokens().takeIf('$'))
    failUnclosed(m_reader.tokens(), column, "$", "$");
  m_reader.add(m_row, {Group{std::move(formula), true}});
}

void TextReader::readCommand() {
  const Token token = m_reader.tokens().take();
  const SymbolCommand *symbol = symbolNamed(token.name);
  if (symbol && symbol->character < 0x80) {
    appendUtf8(m_words, symbol->character);
    return;
  }
  flush();
  m_reader.readCommand(m_row, token);
  if (const Command *command = commandNamed(token.name); command && command->read == &readAlphabetSwitch)
    switchTo(command->alphabet);
}

} // namespace

void readText(LatexReader &reader, Row &row, const CommandCall &call) {
  reader.addGroup(row, TextReader(reader, call.command.alphabet).read(call.column));
}

void readOperatorName(LatexReader &reader, Row &row, const CommandCall &call) {
  const bool hasLimits = reader.tokens().takeIf('*');
  reader.addGroup(row, TextReader(reader, call.command.alphabet).read(call.column));
  Node &name = row.back();
  name.atomClass = AtomClass::Op;
  name.scriptPlace = hasLimits ? ScriptPlace::LimitsInDisplay : ScriptPlace::Beside;
}

void readTag(LatexReader &reader, Row &row, const CommandCall &call) {
  // Its place in LaTeX is the page's margin, which a formula does not know.
  constexpr double roomBefore = 2;
  reader.tokens().takeIf('*');
  Row content = TextReader(reader, call.command.alphabet).read(call.column);
  reader.add(row, space(roomBefore));
  reader.add(row, symbol('(', AtomClass::Open));
  detail::append(row, std::move(content));
  reader.add(row, symbol(')', AtomClass::Close));
}

} // namespace halfspace::math
