// Where a lesson begins.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/scene/session.h"

namespace halfspace {

/// The session of somebody who opens the lesson for the first time.
[[nodiscard]] inline Session startOf(const Lesson &lesson) { return {lesson.id, 0, lesson.scene}; }

} // namespace halfspace
