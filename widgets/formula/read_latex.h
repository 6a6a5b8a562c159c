// Reads the mathematics of LaTeX: what a lecturer in linear algebra writes.
#pragma once

#include "lessons/lesson/macros.h"
#include "widgets/formula/math_tree.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>

namespace halfspace::math {

/// Why something is no formula.
struct ReadError {
  std::size_t column = 1; ///< of the character where it shows, counted from 1
  std::string sentence;   ///< for a person: "`\foo` is unknown."
};

using halfspace::Macro;
using halfspace::Macros;

/// What is larger is refused, so that reading takes bounded time whatever it is given.
inline constexpr std::size_t longestLatex = 65536; ///< bytes
inline constexpr std::size_t mostNodes = 20000;
inline constexpr int deepestNesting = 120;
inline constexpr std::size_t mostExpandedTokens = 100000; ///< that macros may bring

/// The formula, or why it is none. Any bytes may be given. The source is what would stand between dollars.
/// Beyond LaTeX: `\mark{id}{…}` is a tag, rows may be broken by `\\` without an environment, and what Unicode
/// has a character for (λ, ⊥, ², ≤, −) may be typed. A macro that uses itself, directly or through others,
/// makes the formula too long, which is an error (findRecursion tells beforehand which one does).
[[nodiscard]] std::variant<Row, ReadError> readLatex(std::string_view latex, const Macros &macros = {});

} // namespace halfspace::math
