#include "widgets/formula/text_faces.h"

#include <utility>

namespace halfspace::math {

std::optional<TextFaces> readTextFaces(const std::string &folder) {
  TextFaces all;
  for (const char *file : textFaceFiles) {
    auto face = FontFace::fromFile(folder + "/" + file);
    if (!face)
      return {};
    all.faces.push_back(std::move(*face));
  }
  return all;
}

} // namespace halfspace::math
