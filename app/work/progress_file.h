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
/// What the file tells, nothing where it is not there; a file that is there and cannot be read is a problem.
[[nodiscard]] Result<LessonProgress> readProgress(const QString &file);
/// Adds what was done to what the file tells: another window may have written it. A file that cannot be read
/// stays as it is, which is a problem.
[[nodiscard]] std::optional<Problem> addProgress(const LessonProgress &progress, const QString &file);

} // namespace halfspace
