// What a step of a lesson shows of a scene: lines, marks, the case.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// The worked lines that a step shows of a scene.
struct LinesOfStep {
  Working working; ///< all of them, in the order of the page
  /// How many of them stand in each of the step's StepLines. A line that several name stands in the first.
  std::vector<std::size_t> linesIn;
};
[[nodiscard]] LinesOfStep linesOfStep(const LessonStep &step, const Evaluation &evaluation);

/// What a step shows of a scene.
struct Shown : LinesOfStep {
  Figure figure;
  std::string description; ///< the cases of the constructions whose lines are shown, in plain words
  bool degenerate = false; ///< one of them is a warning
};

/// Whether the question of a step, if it has one, is answered. While it is not, the figure has what is given
/// alone: the rest would give the answer away.
enum class Question { Open, Answered };

/// The step's lines and, of the figure, which is that of the evaluation, the given marks, those that these
/// lines and the step name, and what accompanies them. Where a step names no lines, all marks and the lines
/// of the last `mostWorkings` constructions. What the step hides is not there in any case.
[[nodiscard]] Shown shownIn(const LessonStep &step, const Evaluation &evaluation, Figure figure,
                            Question question = Question::Answered);
[[nodiscard]] inline Shown shownIn(const LessonStep &step, const Evaluation &evaluation,
                                   Question question = Question::Answered) {
  return shownIn(step, evaluation, figureOf(evaluation), question);
}
inline constexpr std::size_t mostWorkings = 4;

} // namespace halfspace
