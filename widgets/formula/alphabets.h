// The mathematical alphabets of Unicode: a letter's italic, bold, blackboard … form is a character of its
// own.
#pragma once

#include <cstdint>

namespace halfspace::math {

enum class Alphabet : std::uint8_t {
  Italic,
  Upright,
  Bold,
  BoldItalic,
  Blackboard,
  Script,
  Fraktur,
  Sans,
  Mono
};

/// The character for a Latin or Greek letter or a digit in an alphabet. What the alphabet does not have (a
/// digit in italics, a Greek letter in script) stays as it is, as do all other characters.
[[nodiscard]] char32_t inAlphabet(char32_t character, Alphabet alphabet);

/// The plain letter or digit that a character of an alphabet stands for; 0 for all other characters.
[[nodiscard]] char32_t withoutAlphabet(char32_t character);

} // namespace halfspace::math
