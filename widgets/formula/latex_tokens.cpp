#include "widgets/formula/latex_tokens.h"

#include "lessons/text.h"
#include "lessons/words.h"
#include "widgets/formula/read_latex.h"

namespace halfspace::math {
namespace {

bool isSpace(char32_t c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// The source, character by character.
class Cursor {
public:
  explicit Cursor(std::string_view source) : m_source(source) { decode(); }

  [[nodiscard]] bool atEnd() const { return m_character.length == 0; }
  [[nodiscard]] char32_t character() const { return m_character.code; }
  [[nodiscard]] std::size_t column() const { return m_column; }
  [[nodiscard]] std::size_t offset() const { return m_offset; }

  void advance() {
    m_offset += m_character.length;
    ++m_column;
    decode();
  }

private:
  void decode() {
    m_character = firstCharacter(m_source.substr(m_offset));
    if (m_character.length == 0 && m_offset < m_source.size())
      throw ReadError{m_column, halfspace::words("This byte is no character: the text is not UTF-8.")};
  }

  std::string_view m_source;
  std::size_t m_offset = 0;
  std::size_t m_column = 1;
  Character m_character; ///< no bytes: the end
};

void skipSpaces(Cursor &cursor) {
  while (!cursor.atEnd() && isSpace(cursor.character()))
    cursor.advance();
}

void skipComment(Cursor &cursor) {
  while (!cursor.atEnd() && cursor.character() != '\n')
    cursor.advance();
  skipSpaces(cursor);
}

/// Behind the backslash: letters, or one other character.
Token takeCommand(Cursor &cursor, std::string_view source) {
  Token token{Token::Kind::Command, 0, {}, cursor.column()};
  cursor.advance();
  if (cursor.atEnd())
    throw ReadError{token.column, halfspace::words("A command's name is missing behind the `\\`.")};
  const std::size_t begin = cursor.offset();
  const bool isWord = isAsciiLetter(cursor.character());
  do
    cursor.advance();
  while (isWord && !cursor.atEnd() && isAsciiLetter(cursor.character()));
  token.name = source.substr(begin, cursor.offset() - begin);
  if (isWord)
    skipSpaces(cursor);
  return token;
}

} // namespace

std::vector<Token> tokenize(std::string_view latex) {
  std::vector<Token> tokens;
  tokens.reserve(latex.size());
  for (Cursor cursor(latex); !cursor.atEnd();) {
    const std::size_t column = cursor.column();
    if (cursor.character() == '\\') {
      tokens.push_back(takeCommand(cursor, latex));
    } else if (cursor.character() == '%') {
      skipComment(cursor);
    } else if (isSpace(cursor.character())) {
      skipSpaces(cursor);
      tokens.push_back({Token::Kind::Space, ' ', {}, column});
    } else {
      tokens.push_back({Token::Kind::Character, cursor.character(), {}, column});
      cursor.advance();
    }
  }
  return tokens;
}

std::string sourceOf(const Token &token) {
  switch (token.kind) {
  case Token::Kind::Command:
    return "\\" + std::string(token.name);
  case Token::Kind::Character: {
    std::string text;
    appendUtf8(text, token.character);
    return text;
  }
  case Token::Kind::Space:
    return " ";
  case Token::Kind::End:
    break;
  }
  return {};
}

void appendUtf8(std::string &text, char32_t character) { text += utf8(character); }

bool isAsciiLetter(char32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool isAsciiDigit(char32_t c) { return c >= '0' && c <= '9'; }

} // namespace halfspace::math
