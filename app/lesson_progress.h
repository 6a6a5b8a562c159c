// What a learner has done in the steps of the lessons.
#pragma once

#include "lessons/lesson/task_progress.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

class QJsonArray;
class QString;

namespace halfspace {

struct StepProgress {
  std::optional<std::string> chosen; ///< the answer to the step's question
  std::string right;                 ///< what was right when it was given
  TaskProgress tasks;
  bool operator==(const StepProgress &) const = default;
};

/// By lesson and step.
using LessonProgress = std::map<std::pair<std::string, int>, StepProgress>;

/// A lesson is done when all its tasks are and all its questions are answered.
[[nodiscard]] LessonState stateOf(const Lesson &lesson, const LessonProgress &progress);

/// What has been done according to one or the other; where both have an answer, the first's. So a question
/// that was tried again and left open counts as answered, as it was.
[[nodiscard]] LessonProgress merged(LessonProgress first, const LessonProgress &second);

[[nodiscard]] QJsonArray toJson(const LessonProgress &progress);
/// What toJson wrote; whatever is not of that form is passed over.
[[nodiscard]] LessonProgress progressFrom(const QJsonArray &json);

/// Where the progress stands between starts: a file of the user's data; empty where there is none.
[[nodiscard]] QString progressFile();
/// What the file tells; nothing where it is not there, or cannot be read.
[[nodiscard]] LessonProgress readProgress(const QString &file);
/// Adds what was done to what the file tells: another window may have written it.
[[nodiscard]] std::optional<Problem> addProgress(const LessonProgress &progress, const QString &file);

} // namespace halfspace
