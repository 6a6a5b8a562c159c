// How large figures and their files are, in words.
#pragma once

#include "app/export/preview_figure.h"

#include <QString>

#include <cstddef>

namespace halfspace {

/// 8 × 6.5 cm, 945 × 768 pixels
[[nodiscard]] QString toWords(const FigureExtent &extent);
/// … with the size of its file: 8 × 6.5 cm, 945 × 768 pixels, 14 KB
[[nodiscard]] QString toWords(const FigureExtent &extent, std::size_t bytes);
/// 14 KB, 1.2 MB
[[nodiscard]] QString bytesInWords(std::size_t bytes);

} // namespace halfspace
