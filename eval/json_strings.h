// What stands in the strings of JSON: UTF-8 and escape sequences.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace halfspace {

/// The four hexadecimal digits at the front, or −1.
[[nodiscard]] int hexWord(std::string_view text);

/// Whether four hexadecimal digits are the first, or the second, half of a pair of surrogates.
[[nodiscard]] bool isHighSurrogate(int word);
[[nodiscard]] bool isLowSurrogate(int word);

/// The length of the UTF-8 sequence of more than one byte at the front; 0 where it is not valid.
[[nodiscard]] std::size_t utf8Length(std::string_view text);

/// What a backslash and a letter stand for; 0 for other letters.
[[nodiscard]] char simpleEscape(char letter);

/// The characters of the inside of a string that is known to be well formed.
[[nodiscard]] std::string unescaped(std::string_view inside);

} // namespace halfspace
