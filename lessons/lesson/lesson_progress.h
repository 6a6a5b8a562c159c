// What a learner has done in the steps of the lessons.
#pragma once

#include "lessons/lesson/task_progress.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace halfspace {

struct StepProgress {
  std::optional<std::string> chosen; ///< the answer to the step's question
  std::string right;                 ///< what was right when it was given
  TaskProgress tasks;
  bool operator==(const StepProgress &) const = default;
};

/// Which step of a lesson: by its name, so that it stays the same among others that are put before it. Older
/// files tell its number, counted from 0.
using StepId = std::variant<std::string, int>;

/// By lesson and step.
using LessonProgress = std::map<std::pair<std::string, StepId>, StepProgress>;

/// A step's title; where others before it have the same, with their number in a line below.
[[nodiscard]] std::string nameOfStep(const Lesson &lesson, int step);

/// With names in the place of numbers, as far as these lessons have such steps.
[[nodiscard]] LessonProgress withStepNames(const LessonProgress &progress,
                                           const std::vector<Lesson> &lessons);

/// How far a learner has come with a lesson.
enum class LessonState { New, Begun, Done };

/// A lesson is done when all its tasks are and all its questions are answered.
[[nodiscard]] LessonState stateOf(const Lesson &lesson, const LessonProgress &progress);

/// What has been done according to one or the other; where both have an answer, the first's. So a question
/// that was tried again and left open counts as answered, as it was.
[[nodiscard]] LessonProgress merged(LessonProgress first, const LessonProgress &second);

} // namespace halfspace
