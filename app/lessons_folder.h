// Where the lessons are.
#pragma once

#include "lessons/lesson/lesson.h"

#include <filesystem>

namespace halfspace {

/// The folder of lessons that belongs to this program: share/halfspace/lessons beside the folder of its
/// executable.
[[nodiscard]] std::filesystem::path lessonsFolder();

/// The lessons of this program, and behind them those of these folders.
[[nodiscard]] LessonLibrary allLessons(const std::vector<std::string> &ownFolders);

} // namespace halfspace
