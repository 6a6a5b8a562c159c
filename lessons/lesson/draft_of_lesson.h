// Lessons as drafts, to go on with them.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/lesson_draft.h"

namespace halfspace {

/// The draft that a lesson's file was written of. Nothing where the file says more than a draft does, or says
/// it in another way: it would not be the same any more when it is written again.
[[nodiscard]] std::optional<LessonDraft> draftOf(const Lesson &lesson);

} // namespace halfspace
