// The letters of corners in sentences.
#pragma once

#include <array>
#include <string>

namespace halfspace::test {

/// P₀, P₁ …
[[nodiscard]] inline std::string cornerLetter(std::size_t corner) {
  static constexpr std::array<const char *, 10> digits{"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  return std::string("P") + digits.at(corner);
}

/// The corner with this letter, of so many; their number where none has it.
[[nodiscard]] inline std::size_t cornerWithLetter(const std::string &letter, std::size_t count) {
  std::size_t corner = 0;
  while (corner < count && cornerLetter(corner) != letter)
    ++corner;
  return corner;
}

} // namespace halfspace::test
