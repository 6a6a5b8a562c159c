// A step that a lesson has.
#pragma once

#include "lessons/lesson/lesson.h"

#include <algorithm>

namespace halfspace {

/// The step that is nearest to a number, counted from 0; 0 where there are none.
[[nodiscard]] inline int nearestStep(const Lesson &lesson, int step) {
  return std::clamp(step, 0, std::max(0, static_cast<int>(lesson.steps.size()) - 1));
}

} // namespace halfspace
