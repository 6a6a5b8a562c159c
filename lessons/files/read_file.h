// Files from a stranger's hands: opened, and read whole.
#pragma once

#include "lessons/files/descriptor.h"
#include "lessons/result.h"

#include <cstdint>
#include <filesystem>

namespace halfspace {

struct OpenedFile {
  Descriptor descriptor;
  std::uint64_t bytes = 0; ///< as many as it had when it was looked at
};

/// Opens a regular file (links are followed) for reading. Folders, pipes and devices are named as what they
/// are and never waited for.
[[nodiscard]] Result<OpenedFile> openFile(const std::filesystem::path &file);

/// The content of a regular file (links are followed) of at most so many bytes. Folders, pipes and devices
/// are refused as by `openFile`; reading stops soon after the limit.
[[nodiscard]] Result<std::string> readFile(const std::filesystem::path &file, std::size_t mostBytes);

} // namespace halfspace
