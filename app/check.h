// What is wrong in lesson files, before a learner meets it.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// What kept lessons of this file, or of the files of this folder, from being read, and the formulas in their
/// words that cannot be.
struct Checked {
  std::size_t lessons = 0; ///< that can be opened
  std::vector<Problem> problems;
};
[[nodiscard]] Checked checkLessons(const std::filesystem::path &fileOrFolder);

} // namespace halfspace
