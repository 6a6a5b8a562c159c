// A lesson to begin with.
#pragma once

#include "lessons/result.h"

#include <filesystem>
#include <string>

namespace halfspace {

/// Writes `<id>.md` into a folder: a lesson with a question, worked lines and a task, in which `check` finds
/// nothing wrong. Refuses what cannot be an id, and to write over a file. The file that it wrote.
[[nodiscard]] Result<std::filesystem::path> writeNewLesson(const std::string &id,
                                                           const std::filesystem::path &folder);

} // namespace halfspace
