// Pictures as VTK has them: rows from bottom to top, where ours go from top to bottom.
#pragma once

#include "widgets/picture/rgba_image.h"

class vtkImageData;

namespace halfspace {

/// Copies rows of pixels, four bytes each, the last one first.
void copyUpsideDown(const std::uint8_t *from, std::uint8_t *to, int width, int height);

/// Fills an image with the picture.
void write(const RgbaImage &picture, vtkImageData *image);

} // namespace halfspace
