// Small matters of text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// From a to z, or from A to Z.
[[nodiscard]] constexpr bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// The text without the white space at its ends.
[[nodiscard]] inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  const auto begin = text.find_first_not_of(space);
  if (begin == std::string_view::npos)
    return {};
  return text.substr(begin, text.find_last_not_of(space) - begin + 1);
}

/// The parts of a text between separators, one more than there are of these, without the white space around
/// them.
[[nodiscard]] std::vector<std::string_view> partsOf(std::string_view text, std::string_view separators);

/// The text with `to` in every place of `from`, which is not empty.
[[nodiscard]] std::string replacedAll(std::string text, std::string_view from, std::string_view to);

/// A character of a text, and how many bytes it takes there: 1 to 4.
struct Character {
  char32_t code = 0;
  std::size_t length = 0;
};

/// The character that a text begins with; of no bytes where it is not UTF-8 (overlong forms and halves of
/// surrogate pairs are not), and where there is none.
[[nodiscard]] Character firstCharacter(std::string_view text);
[[nodiscard]] inline std::size_t characterLength(std::string_view text) {
  return firstCharacter(text).length;
}
/// How many bytes of a text ≠ "" stand together: those of its first character, or one that is none's.
[[nodiscard]] inline std::size_t lengthOfFirst(std::string_view text) {
  const std::size_t length = characterLength(text);
  return length > 0 ? length : 1;
}

/// Whether a byte goes on with a character that began before it.
[[nodiscard]] constexpr bool continuesCharacter(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// The character of a number as text; empty where the number is no character's.
[[nodiscard]] std::string utf8(unsigned code);

/// Where a text stops being text: at a byte that is not UTF-8, or at a control character other than a tab or
/// an end of a line. Nothing for a text.
[[nodiscard]] std::optional<std::size_t> firstNoText(std::string_view bytes);

/// The text with � for each character that would steer a terminal or turn the direction of writing
/// instead of being read, and for each byte that is not UTF-8. Tabs and ends of lines stay.
[[nodiscard]] std::string printable(std::string_view text);

/// A text cut to a length that fits a sentence, for showing what was found.
[[nodiscard]] std::string shortened(std::string_view text);

} // namespace halfspace
