#include "widgets/scene/vtk_image.h"

#include <vtkImageData.h>

#include <algorithm>

namespace halfspace {

void copyUpsideDown(const std::uint8_t *from, std::uint8_t *to, int width, int height) {
  const auto rowBytes = static_cast<std::ptrdiff_t>(width) * 4;
  for (int row = 0; row < height; ++row)
    std::copy_n(from + row * rowBytes, rowBytes, to + (height - 1 - row) * rowBytes);
}

void write(const RgbaImage &picture, vtkImageData *image) {
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  copyUpsideDown(picture.rgba.data(), static_cast<std::uint8_t *>(image->GetScalarPointer()), picture.width,
                 picture.height);
  image->Modified();
}

} // namespace halfspace
