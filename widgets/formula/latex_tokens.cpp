#include "widgets/formula/latex_tokens.h"

#include "lessons/words.h"
#include "widgets/formula/read_latex.h"

namespace halfspace::math {
namespace {

bool isSpace(char32_t c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

bool isContinuation(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// How many bytes a character has that begins with this one; 0: none begins so.
std::size_t lengthFrom(unsigned char first) {
  if (first < 0x80)
    return 1;
  if (first >= 0xC2 && first < 0xE0)
    return 2;
  if (first >= 0xE0 && first < 0xF0)
    return 3;
  return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// Whether Unicode has this character, and needs this many bytes for it.
bool isWellFormed(char32_t character, std::size_t length) {
  if (character >= 0xD800 && character < 0xE000)
    return false;
  return (length < 3 || character >= 0x800) && (length < 4 || character >= 0x10000) && character < 0x110000;
}

/// The source, character by character.
class Cursor {
public:
  explicit Cursor(std::string_view source) : m_source(source) { decode(); }

  [[nodiscard]] bool atEnd() const { return m_length == 0; }
  [[nodiscard]] char32_t character() const { return m_character; }
  [[nodiscard]] std::size_t column() const { return m_column; }
  [[nodiscard]] std::size_t offset() const { return m_offset; }

  void advance() {
    m_offset += m_length;
    ++m_column;
    decode();
  }

private:
  void decode() {
    m_length = 0;
    if (m_offset == m_source.size())
      return;
    const auto first = static_cast<unsigned char>(m_source[m_offset]);
    m_length = lengthFrom(first);
    if (m_length == 0 || m_offset + m_length > m_source.size())
      failHere();
    m_character = m_length == 1 ? first : first & (0xFFU >> (m_length + 1));
    for (std::size_t i = 1; i < m_length; ++i) {
      const char byte = m_source[m_offset + i];
      if (!isContinuation(byte))
        failHere();
      m_character = (m_character << 6U) | (static_cast<unsigned char>(byte) & 0x3FU);
    }
    if (!isWellFormed(m_character, m_length))
      failHere();
  }

  [[noreturn]] void failHere() const {
    throw ReadError{m_column, halfspace::words("This byte is no character: the text is not UTF-8.")};
  }

  std::string_view m_source;
  std::size_t m_offset = 0;
  std::size_t m_length = 0;
  std::size_t m_column = 1;
  char32_t m_character = 0;
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

void appendUtf8(std::string &text, char32_t character) {
  const auto push = [&text](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  const auto continuation = [&](unsigned shift) { push(0x80U | ((character >> shift) & 0x3FU)); };
  if (character < 0x80) {
    push(character);
  } else if (character < 0x800) {
    push(0xC0U | (character >> 6U));
    continuation(0);
  } else if (character < 0x10000) {
    push(0xE0U | (character >> 12U));
    continuation(6);
    continuation(0);
  } else {
    push(0xF0U | (character >> 18U));
    continuation(12);
    continuation(6);
    continuation(0);
  }
}

bool isAsciiLetter(char32_t c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool isAsciiDigit(char32_t c) { return c >= '0' && c <= '9'; }

} // namespace halfspace::math
