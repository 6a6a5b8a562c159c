// Explore: a lesson without words, in which users build scenes of their own.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// The id that sessions have in it.
inline constexpr const char *exploreId = "explore";

/// It begins empty, has one step, and is in no folder: every library knows it.
[[nodiscard]] const Lesson &exploreLesson();

/// What a window shows of it in the place of its step: what is given, the lines of these constructions with
/// all that they draw, and of the others what comes out.
[[nodiscard]] LessonStep stepShowing(const std::vector<std::string> &constructions);

} // namespace halfspace
