// Where the lessons are.
#pragma once

#include <filesystem>

namespace halfspace {

/// The folder of lessons that belongs to this program: share/halfspace/lessons beside the folder of its
/// executable.
[[nodiscard]] std::filesystem::path lessonsFolder();

} // namespace halfspace
