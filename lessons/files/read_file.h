// The one reader of whole files, from a stranger's hands.
#pragma once

#include "lessons/reading/problem.h"

#include <filesystem>

namespace halfspace {

/// The content of a regular file (links are followed) of at most so many bytes. Folders, pipes and devices
/// are named as what they are and never waited for; reading stops soon after the limit.
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path &file, std::size_t mostBytes);

} // namespace halfspace
