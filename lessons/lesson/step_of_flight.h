// The step by which a lesson's flight is shown.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// The last step that shows the lesson's flight; null where it has none.
[[nodiscard]] inline const LessonStep *stepOfFlight(const Lesson &lesson) {
  const LessonStep *last = nullptr;
  for (const LessonStep &step : lesson.steps)
    if (flightOf(step))
      last = &step;
  return last;
}

} // namespace halfspace
