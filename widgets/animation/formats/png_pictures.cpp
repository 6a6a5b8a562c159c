// A PNG picture for each moment, with its number in the file's name.
#include "lessons/files/numbered_file.h"
#include "lessons/words.h"
#include "widgets/animation/animation_format.h"
#include "widgets/scene/png.h"

#include <utility>

namespace halfspace {
namespace {

class PngPictures : public Encoder {
public:
  explicit PngPictures(NumberedFile file) : m_file(std::move(file)) {}

  [[nodiscard]] std::optional<Problem> add(const RgbaImage &picture) override {
    return writePng(picture, fileOf(m_file, m_number++));
  }
  [[nodiscard]] std::optional<Problem> finish() override { return {}; }

private:
  NumberedFile m_file;
  int m_number = 0;
};

Result<std::unique_ptr<Encoder>> beginPngPictures(const EncodingRequest &request) {
  auto file = parseNumberedFile(request.file);
  if (!file)
    return Problem{
        words("Several pictures need a place for their number in the file's name: frames/%04d.png."), "", 0,
        ""};
  return std::unique_ptr<Encoder>(std::make_unique<PngPictures>(std::move(*file)));
}

} // namespace

AnimationFormat png_pictures() {
  AnimationFormat format;
  format.name = "PNG";
  format.ending = ".png";
  format.isNumbered = true;
  format.mayBeTransparent = true;
  format.begin = beginPngPictures;
  return format;
}

} // namespace halfspace
