// Pictures as PNG files.
#pragma once

#include "lessons/result.h"
#include "widgets/picture/rgba_image.h"

#include <filesystem>
#include <optional>

namespace halfspace {

/// Writes a PNG file, as writeFile does.
[[nodiscard]] std::optional<Problem> writePng(const RgbaImage &picture, const std::filesystem::path &file);

} // namespace halfspace
