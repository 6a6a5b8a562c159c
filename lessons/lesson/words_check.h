// The words of a lesson's steps, where they are not seen as they are meant.
#pragma once

#include "lessons/lesson/lesson.h"

#include <vector>

namespace halfspace {

/// Headings that begin no step though they look like it, blocks of code with nearly the name of an
/// instruction, and dollars without a partner, each with its line.
[[nodiscard]] std::vector<Problem> problemsWithWords(const Lesson &lesson);

} // namespace halfspace
