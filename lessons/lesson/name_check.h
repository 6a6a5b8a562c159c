// The names in a lesson: lines, marks and values, held against what its scene can come to.
#pragma once

#include "lessons/lesson/lesson.h"

#include <vector>

namespace halfspace {

/// The problems with the names that a lesson's steps use, each with its line: those that no entry of the
/// scene has in any of its cases, or several have; comparisons with what a value can never be; and live
/// values that are not there at the start. Each says what was perhaps meant.
[[nodiscard]] std::vector<Problem> problemsWithNames(const Lesson &lesson);

} // namespace halfspace
