// What a PLY file says about itself at its beginning.
#pragma once

#include "lessons/reading/problem.h"

#include <cstdint>
#include <string_view>

namespace halfspace {

/// The least content is told up to here.
inline constexpr std::uint64_t mostLeastContent = 1ULL << 62U;

struct PlyHeader {
  std::uint64_t bytes = 0; ///< of the header itself, its last line included
  std::uint64_t corners = 0;
  std::uint64_t faces = 0;
  /// What the elements that it announces take at least, up to `mostLeastContent`.
  std::uint64_t leastContent = 0;
};

/// Reads the header that a file begins with. A face is taken to have three corners at least.
[[nodiscard]] Result<PlyHeader> readPlyHeader(std::string_view head);

} // namespace halfspace
