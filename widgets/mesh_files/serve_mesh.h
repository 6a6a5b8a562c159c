// The process that reads a stranger's mesh file, so that what the file does to the reader is done to nobody
// else.
#pragma once

#include "lessons/files/bound_process.h"

#include <chrono>
#include <filesystem>

namespace halfspace {

/// The hidden command of the program that does this: `halfspace read-mesh FILE`.
inline constexpr const char *readMeshCommand = "read-mesh";

/// More memory and time than this is not given to reading a file.
inline constexpr ProcessBounds readingBounds{4ULL << 30U, 120};
/// Who waits for the process waits no longer: a disk that is slow or gone takes no time of the processor.
inline constexpr std::chrono::milliseconds longestReading = std::chrono::minutes(3);

/// Reads the file and writes to the descriptor what a `MeshDecoder` takes. The exit status: 0 where a mesh
/// was written whole.
[[nodiscard]] int serveMesh(const std::filesystem::path &file, int descriptor);

} // namespace halfspace
