// How large figures and their files are, in words.
#pragma once

#include "app/export/preview_figure.h"

#include <QString>

#include <cstddef>

namespace halfspace {

/// 8 × 6.5 cm, 945 × 768 pixels
[[nodiscard]] QString toWords(const FigureExtent &extent);
/// 14 KB, 1.2 MB
[[nodiscard]] QString bytesInWords(std::size_t bytes);

} // namespace halfspace
