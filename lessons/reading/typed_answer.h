// Answers as learners type them: numbers, lists of numbers, equations.
#pragma once

#include "lessons/term/term_value.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace halfspace {

/// A number as it was typed. A decimal stands for all numbers that round to it.
struct TypedEntry {
  Polynomial value;
  std::optional<Rational> rounding{}; ///< half a unit in the last place of a decimal
};

/// One number, or the entries of a list; or an equation, whose value is its left side less its right one.
struct TypedAnswer {
  std::vector<TypedEntry> entries;
  bool isList = false;
  bool isEquation = false;

  [[nodiscard]] TermValue value() const;
  /// Whether the answer is this value, or rounds to it.
  [[nodiscard]] bool means(const TermValue &value) const;
  /// Whether the answer, taken for an equation, has the same solutions as `left` = 0: one is a multiple of
  /// the other.
  [[nodiscard]] bool meansEquation(const TermValue &left) const;
};

/// Numbers are 10, -10/3, -3 1/3, 3.33, 2*sqrt(43)/3, 2√43/3, 30/√43, 1 + √2, and whatever sums and products
/// make of them; 10 3 is none. Several are typed as (1, -3 1/3, √2), in parentheses or without, parted by
/// commas, or by semicolons where the comma is a decimal mark. Equations have letters: x + 2y + 2z = 27.
/// Nothing for any other text, for numbers that leave A + B√n, and for texts of more than `longestAnswer`
/// bytes. Where the comma is the decimal mark, 1,5 is 3/2, and (1, 2, 3) and (1,2,3) are lists still.
///
/// Where so many numbers are asked for, more than one, as many that have nothing but spaces between them are
/// a list too: 1 -2 -3 is (1, -2, -3) then, and not their sum.
[[nodiscard]] std::optional<TypedAnswer> readAnswer(std::string_view text, char decimalMark = '.',
                                                    std::size_t numbersAskedFor = 1);
inline constexpr std::size_t longestAnswer = 120;
/// Products of sums of letters grow without end: an answer with more summands is none.
inline constexpr std::size_t mostSummands = 64;

/// A decimal with fewer digits than this is taken for the number itself: it is too short to be rounded.
inline constexpr std::size_t fewestDigits = 2;

} // namespace halfspace
