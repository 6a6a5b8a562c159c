#include "widgets/scene/offscreen.h"

#include "lessons/files/write_file.h"
#include "lessons/words.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace halfspace {
namespace {

vtkNew<vtkImageData> imageOf(const LabelPicture &picture) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const auto rowBytes = static_cast<std::ptrdiff_t>(picture.width) * 4;
  for (int row = 0; row < picture.height; ++row) // VTK's rows go from bottom to top
    std::copy_n(picture.rgba.data() + row * rowBytes, rowBytes,
                static_cast<std::uint8_t *>(image->GetScalarPointer(0, picture.height - 1 - row, 0)));
  return image;
}

} // namespace

std::optional<Problem> writePng(const LabelPicture &picture, const std::filesystem::path &file) {
  if (picture.width < 1 || picture.height < 1)
    return Problem{words("The picture is empty."), file.string(), 0, {}};
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(imageOf(picture));
  writer->WriteToMemoryOn();
  writer->Write();

  vtkUnsignedCharArray *bytes = writer->GetResult();
  if (!bytes)
    return Problem{words("There is not enough memory for this picture."), file.string(), 0, {}};
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): files are chars.
  return writeFile(file, {reinterpret_cast<const char *>(bytes->GetPointer(0)),
                          static_cast<std::size_t>(bytes->GetNumberOfValues())});
}

} // namespace halfspace
