#include "widgets/scene/offscreen.h"

#include "lessons/words.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <fstream>
#include <system_error>

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

bool writeBytes(const vtkUnsignedCharArray &bytes, const std::filesystem::path &file) {
  std::ofstream stream(file, std::ios::binary | std::ios::trunc);
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): streams write chars.
  stream.write(reinterpret_cast<const char *>(const_cast<vtkUnsignedCharArray &>(bytes).GetPointer(0)),
               static_cast<std::streamsize>(bytes.GetNumberOfValues()));
  stream.close();
  return !stream.fail();
}

} // namespace

std::optional<Problem> writePng(const LabelPicture &picture, const std::filesystem::path &file) {
  if (picture.width < 1 || picture.height < 1)
    return Problem{words("The picture is empty."), file.string(), 0, {}};
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(imageOf(picture));
  writer->WriteToMemoryOn();
  writer->Write();

  std::filesystem::path unfinished = file;
  unfinished += ".part";
  std::error_code error;
  if (writer->GetResult() && writeBytes(*writer->GetResult(), unfinished)) {
    std::filesystem::rename(unfinished, file, error);
    if (!error)
      return {};
  }
  std::filesystem::remove(unfinished, error);
  return Problem{words("The picture cannot be written there: does the folder exist, may you write to it, and "
                       "is there room?"),
                 file.string(), 0, ""};
}

} // namespace halfspace
