// Images as they are painted and written to files.
#pragma once

#include <cstdint>
#include <vector>

namespace halfspace {

/// Rows from top to bottom, four bytes a pixel: red, green, blue, straight alpha.
struct RgbaImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgba;
};

} // namespace halfspace
