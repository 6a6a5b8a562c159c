// Wrong answers as learners come to them, calculated from a scene's objects alone: what is measured with them
// knows nothing of how the program finds mistakes.
#pragma once

#include "lessons/construction/construction.h"

#include <span>
#include <string>
#include <vector>

namespace halfspace::test {

/// One thing done wrongly in one line.
struct WrongAnswer {
  std::string line; ///< the id of the worked line
  std::string how;  ///< what was done wrongly, in a few words: the same for all scenes
  std::string typed;
};

/// The wrong answers to the lines of a construction that ask for a number, without those that come to the
/// right answer all the same. One value may come up for several reasons. None for a scene without an answer
/// of the usual kind. Throws std::out_of_range for a construction that has no wrong answers yet: add them
/// here.
[[nodiscard]] std::vector<WrongAnswer> wrongAnswers(std::string_view construction,
                                                    std::span<const Object *const> objects);

} // namespace halfspace::test
