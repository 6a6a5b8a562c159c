// The process that reads a stranger's mesh file, so that what the file does to the reader is done to nobody
// else.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>

namespace halfspace {

/// The hidden command of the program that does this: `halfspace read-mesh FILE`.
inline constexpr const char *readMeshCommand = "read-mesh";

/// More memory and time than this is not given to reading a file.
inline constexpr std::size_t mostReadingMemory = 4ULL << 30U;
inline constexpr unsigned mostReadingSeconds = 120; ///< of the processor
/// Who waits for the process waits no longer: a disk that is slow or gone takes no time of the processor.
inline constexpr std::chrono::milliseconds longestReading = std::chrono::minutes(3);

/// Bounds the memory and the time of this process from now on (memory not where a sanitizer needs it), and
/// keeps it from leaving its memory behind when it ends.
void boundThisProcess(std::size_t memory = mostReadingMemory, unsigned seconds = mostReadingSeconds);

/// Reads the file and writes to the descriptor what a `MeshDecoder` takes. The exit status: 0 where a mesh
/// was written whole.
[[nodiscard]] int serveMesh(const std::filesystem::path &file, int descriptor);

} // namespace halfspace
