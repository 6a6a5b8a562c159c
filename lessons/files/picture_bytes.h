// What is in the files of pictures, told from their bytes before anything is unpacked.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace halfspace {

/// A PNG file with only those pieces that are seen. Others may hold much more than the picture once they are
/// unpacked, as compressed text does. What does not go on as a PNG file does is cut off.
[[nodiscard]] std::string seenPartOfPng(std::string_view png);

/// How often a JPEG file goes over its picture.
[[nodiscard]] std::size_t scansOfJpeg(std::string_view jpeg);

} // namespace halfspace
