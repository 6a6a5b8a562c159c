// Worked lines that a learner completes: which of them are blank, and what an answer is worth.
#pragma once

#include "lessons/working.h"

#include <set>
#include <string_view>

namespace halfspace {

/// How much of a working is left to the learner: nothing, the last line that asks for a number, all lines.
enum class Fading { None, Last, All };

/// The fading that a lesson's word means: none, last, all.
[[nodiscard]] std::optional<Fading> fadingNamed(std::string_view word);
[[nodiscard]] std::string_view nameOf(Fading fading);

/// The ids of the lines whose numbers are blank. `opened` are those that the learner has completed or had
/// shown. Lines below the last one that asks, which would give its result away, wait for it.
[[nodiscard]] std::set<std::string> blankLines(const Working &working, Fading fading,
                                               const std::set<std::string> &opened);

/// The number that a learner's answer means: 10, -10/3, -3 1/3, 3.33, 2*sqrt(43)/3, 2√43/3, 30/√43, 1 + √2.
/// Nothing for any other text and for texts of more than `longestAnswer` bytes.
[[nodiscard]] std::optional<Surd> parseAnswer(std::string_view text);
inline constexpr std::size_t longestAnswer = 60;

struct Judgement {
  bool right = false;
  std::string sentence;
  bool isAnswer = true; ///< false: what was typed cannot be read as one
};

/// Several numbers are typed as (1, -3 1/3, √2), in parentheses or without, parted by commas, or by
/// semicolons where the comma is a decimal mark. Compares a typed answer with what is asked, then with what
/// the usual mistakes come to. A decimal is right when the number rounds to it, if it has at least
/// `fewestDigits` digits; the sentence says that it is rounded.
[[nodiscard]] Judgement judge(const Blank &blank, std::string_view typed);
inline constexpr std::size_t fewestDigits = 2;

} // namespace halfspace
