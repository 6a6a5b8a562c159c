// What is wrong in lesson files, before a learner meets it.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// What in one lesson would not be seen or found as it is meant, from top to bottom: its words, their
/// formulas and pictures, and the names that it uses.
[[nodiscard]] std::vector<Problem> problemsIn(const Lesson &lesson);

/// What kept lessons of files, or of the files of folders, from being read, what is wrong in the others,
/// and how they do not fit to those beside them and to the program's own.
struct Checked {
  std::size_t lessons = 0; ///< that can be opened
  std::vector<Problem> problems;
};
[[nodiscard]] Checked checkLessons(const std::vector<std::filesystem::path> &filesAndFolders,
                                   const LessonLibrary &ours);

} // namespace halfspace
