// Photographs and scans as shades of grey: all that codes are looked for in.
#pragma once

#include "lessons/result.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace halfspace {

/// Rows from top to bottom, a byte a pixel: 0 is black.
struct GreyImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

/// Pictures of more pixels than this are not unpacked. The largest are those of scanners: a page of A4 has
/// half as many at 600 dpi. Cameras make some that are larger, but a code is read in smaller ones as well.
inline constexpr int mostGreyPixels = 1 << 26;

/// JPEG pictures that go over their pixels more often are not unpacked. Each time may take a second, and
/// those of cameras and scanners do it a dozen times at most.
inline constexpr std::size_t mostGreyScans = 24;

/// Whether a file is one of those that can be unpacked, PNG or JPEG, by how it begins.
[[nodiscard]] bool isPixelPicture(std::string_view file);

/// The pixels of a PNG or JPEG picture from a stranger's hands; what is transparent lies on white. Of a JPEG
/// picture that is damaged or cut off, as much as is there. A sentence where it is damaged otherwise, or has
/// too many pixels.
[[nodiscard]] Result<GreyImage> greyImageOf(std::string_view file);

/// The same with twice as many pixels in a row and in a column, and shades between those that are neighbours.
[[nodiscard]] GreyImage doubled(const GreyImage &image);

} // namespace halfspace
