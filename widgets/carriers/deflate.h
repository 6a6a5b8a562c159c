// Bytes deflated and inflated, in zlib's format.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace halfspace {

/// As small as zlib makes it; empty where memory ends.
[[nodiscard]] std::string deflated(std::string_view content);

struct Inflated {
  std::string content;
  bool isWhole = false; ///< it ended where it should, with the right checksum
};

/// What a stranger's bytes, which something else may follow, unpack to. Stops soon after `mostBytes`: more of
/// them than that, and what is damaged, is not whole.
[[nodiscard]] Inflated inflated(std::string_view packed, std::size_t mostBytes);

} // namespace halfspace
