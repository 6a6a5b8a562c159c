#include "widgets/scene/png.h"

#include "lessons/files/write_file.h"
#include "lessons/words.h"
#include "widgets/scene/vtk_image.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

namespace halfspace {

Result<std::string> pngOf(const RgbaImage &picture) {
  if (picture.width < 1 || picture.height < 1)
    return Problem{words("The picture is empty."), "", 0, ""};
  vtkNew<vtkImageData> image;
  write(picture, image);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();

  vtkUnsignedCharArray *bytes = writer->GetResult();
  if (!bytes)
    return Problem{words("There is not enough memory for this picture."), "", 0, ""};
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): files are chars.
  return std::string(reinterpret_cast<const char *>(bytes->GetPointer(0)),
                     static_cast<std::size_t>(bytes->GetNumberOfValues()));
}

std::optional<Problem> writePng(const RgbaImage &picture, const std::filesystem::path &file) {
  const auto content = pngOf(picture);
  if (!content)
    return Problem{content.problem().sentence, file.string(), 0, ""};
  return writeFile(file, *content);
}

} // namespace halfspace
