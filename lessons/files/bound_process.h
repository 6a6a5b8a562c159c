// Bounds of what a process may take, for those that read strangers' files.
#pragma once

#include <cstddef>
#include <optional>

namespace halfspace {

struct ProcessBounds {
  std::optional<std::size_t> memory{}; ///< in bytes, with what the process has already
  unsigned seconds = 0;                ///< of the processor
};

/// Bounds this process from now on (its memory not where a sanitizer needs it), and keeps it from leaving its
/// memory behind when it ends. It ends with the one that started it.
void boundThisProcess(const ProcessBounds &bounds);

} // namespace halfspace
