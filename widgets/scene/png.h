// Pictures as PNG files.
#pragma once

#include "lessons/result.h"
#include "widgets/picture/rgba_image.h"

#include <filesystem>
#include <optional>

namespace halfspace {

/// A picture as the content of a PNG file.
[[nodiscard]] Result<std::string> pngOf(const RgbaImage &picture);

/// Writes a PNG file, as writeFile does.
[[nodiscard]] std::optional<Problem> writePng(const RgbaImage &picture, const std::filesystem::path &file);

} // namespace halfspace
