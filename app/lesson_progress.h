// What a learner has done in the steps of the lessons.
#pragma once

#include "lessons/lesson/task_progress.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

class QJsonArray;

namespace halfspace {

struct StepProgress {
  std::optional<std::string> chosen; ///< the answer to the step's question
  std::string right;                 ///< what was right when it was given
  TaskProgress tasks;
  bool operator==(const StepProgress &) const = default;
};

/// By lesson and step.
using LessonProgress = std::map<std::pair<std::string, int>, StepProgress>;

[[nodiscard]] QJsonArray toJson(const LessonProgress &progress);
/// What toJson wrote; whatever is not of that form is passed over.
[[nodiscard]] LessonProgress progressFrom(const QJsonArray &json);

} // namespace halfspace
