// LaTeX as a list of tokens.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace::math {

struct Token {
  enum class Kind : std::uint8_t { Character, Command, Space, End };

  Kind kind = Kind::End;
  char32_t character = 0; ///< of a Character
  std::string_view name;  ///< of a Command, without the backslash; lies in the source
  std::size_t column = 1; ///< counted in characters, from 1

  [[nodiscard]] bool is(char32_t wanted) const { return kind == Kind::Character && character == wanted; }
  [[nodiscard]] bool isCommand(std::string_view wanted) const {
    return kind == Kind::Command && name == wanted;
  }
  [[nodiscard]] bool isEnd() const { return kind == Kind::End; }
};

/// All tokens but an End. White space is one Space, comments are left out, a Space behind a command's name
/// too. Throws ReadError where the source is not UTF-8.
[[nodiscard]] std::vector<Token> tokenize(std::string_view latex);

/// As it was written, for a sentence.
[[nodiscard]] std::string sourceOf(const Token &token);

/// Appends a character in UTF-8.
void appendUtf8(std::string &text, char32_t character);

[[nodiscard]] bool isAsciiLetter(char32_t character);
[[nodiscard]] bool isAsciiDigit(char32_t character);

} // namespace halfspace::math
