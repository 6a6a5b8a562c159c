// Lessons while somebody writes them.
#pragma once

#include "app/work/known_file.h"
#include "lessons/lesson/lesson_draft.h"

#include <map>
#include <string>

class QJsonValue;

namespace halfspace {

/// What is being written, and the file that it stands in as it was when it was last saved.
struct LessonWork {
  LessonDraft draft{};
  KnownFile file{};     ///< without a path as long as it stands in none
  bool isSaved = false; ///< the draft is as its file has it
  bool operator==(const LessonWork &) const = default;
};

/// By the id of the lesson that they are made of: Explore, or the lesson itself.
using LessonWorks = std::map<std::string, LessonWork>;

/// Whether one of them would be lost.
[[nodiscard]] bool hasUnsaved(const LessonWorks &works);

[[nodiscard]] QJsonValue toJson(const LessonWorks &works);
/// What toJson wrote; whatever is not of that form is passed over.
[[nodiscard]] LessonWorks lessonWorksFrom(const QJsonValue &json);

} // namespace halfspace
