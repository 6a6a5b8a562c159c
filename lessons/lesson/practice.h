// Worked lines that a learner completes: what is left out of them, and what an answer is worth.
#pragma once

#include "lessons/lesson/gap_choice.h"

#include <map>
#include <optional>
#include <set>
#include <string_view>

namespace halfspace {

/// How much of a working is left to the learner: nothing, a number of each line, the last result that is
/// asked for, all results.
enum class Fading { None, Gaps, Last, All };

/// The fading that a lesson's word means: none, gaps, last, all.
[[nodiscard]] std::optional<Fading> fadingNamed(std::string_view word);

// Of lines of one statement:

/// The line's result left out.
[[nodiscard]] Gap resultGap(const WorkingLine &line);

/// What the lines of a working leave out, by their ids.
struct Fade {
  std::map<std::string, Gap> gaps;
  /// Lines that ask for nothing but would give away what is left out elsewhere: they show symbols only, until
  /// that is found.
  std::set<std::string> waiting;
};

/// `opened` are the lines that the learner has completed or had shown.
[[nodiscard]] Fade fade(const Working &working, Fading fading, const std::set<std::string> &opened);

/// Asks for nothing, and shows symbols only wherever there are numbers.
[[nodiscard]] Fade withheld(const Working &working);

/// The line, in which nothing of what is demanded tells whether it can be met: a crossed sign of equality
/// would give away what is asked.
[[nodiscard]] WorkingLine asDemand(WorkingLine line);

/// The line with what is left out of it: f(Q) = n·(Q − P₀), or t = −30/? = −10/3.
[[nodiscard]] std::string questionText(const WorkingLine &line, const Gap &gap);

/// The names by which what is left out is found that no line of this working says the value of: to be
/// told beside the gap.
[[nodiscard]] std::vector<Chain> toldFor(const WorkingLine &line, const Gap &gap, const Working &shown);

struct Judgement {
  bool right = false;
  std::string sentence;
  bool isAnswer = true; ///< false: it cannot be read as one, or has not as many numbers as are asked for
};

/// Compares a typed answer with what is left out, then with what the usual mistakes come to. A decimal is
/// right when the number rounds to it; the sentence says that it is rounded. It is typed with
/// the language's mark.
[[nodiscard]] Judgement judge(const WorkingLine &line, const Gap &gap, std::string_view typed);

} // namespace halfspace
