// Where the lessons are.
#pragma once

#include "lessons/lesson/lesson.h"

#include <filesystem>

namespace halfspace {

/// The folder of lessons that belongs to this program: share/halfspace/lessons beside the folder of its
/// executable.
[[nodiscard]] std::filesystem::path lessonsFolder();

/// Whether both paths lead to one folder.
[[nodiscard]] bool areOneFolder(const std::filesystem::path &one, const std::filesystem::path &other);

/// The lessons of this program, and behind them those of these folders, each once.
[[nodiscard]] LessonLibrary allLessons(const std::vector<std::string> &ownFolders);

} // namespace halfspace
