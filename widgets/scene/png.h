// Pictures as PNG files.
#pragma once

#include "lessons/result.h"
#include "widgets/picture/labels/label_picture.h"

#include <filesystem>
#include <optional>

namespace halfspace {

/// Writes a PNG file, as writeFile does.
[[nodiscard]] std::optional<Problem> writePng(const LabelPicture &picture, const std::filesystem::path &file);

} // namespace halfspace
