// What a PNG file is made of: a signature, and chunks. Source: the PNG specification, 5.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

inline constexpr std::string_view pngSignature = "\x89PNG\r\n\x1a\n";

[[nodiscard]] inline bool isPng(std::string_view file) { return file.starts_with(pngSignature); }

struct PngChunk {
  std::string_view type; ///< four letters
  std::string_view data;
  bool isWhole = false; ///< its checksum is right
};

/// Takes a chunk off the front of what stands behind the signature; nothing where none is there to its end.
[[nodiscard]] std::optional<PngChunk> takePngChunk(std::string_view &file);

/// A picture with one more chunk, directly behind its sizes, which stand first. What is no whole picture
/// stays as it is.
[[nodiscard]] std::string withPngChunk(std::string picture, std::string_view type, std::string_view data);

/// A picture that says how large it is: so many of its pixels make an inch.
[[nodiscard]] std::string withPixelDensity(std::string picture, double pixelsPerInch);

} // namespace halfspace
