// What a learner has done, as it is kept between starts.
#pragma once

#include "lessons/lesson/lesson_progress.h"

class QJsonArray;
class QString;

namespace halfspace {

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
