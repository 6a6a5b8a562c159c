#include "widgets/typeset/text_faces.h"

#include "widgets/typeset/embedded_font.h"

namespace halfspace {

math::TextFaces textFaces() {
  math::TextFaces all;
  for (const char *file : math::textFaceFiles)
    all.faces.push_back(math::FontFace::fromMemory(embeddedFont(file)).value());
  return all;
}

} // namespace halfspace
