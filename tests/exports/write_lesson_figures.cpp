// Writes the whole figure of every lesson in every format into a folder, so that what was built by another
// compiler, or on another day, can be compared with it: scripts/check-same-figures.sh.
#include "lessons/files/write_file.h"
#include "tests/exports/lesson_drawings.h"
#include "widgets/exports/format.h"

#include <cstdio>

namespace halfspace {
namespace {

int writeFiguresInto(const std::filesystem::path &folder) {
  const PaperLook look;
  constexpr double typeSize = 9;
  const Theme &theme = *findTheme("print");
  for (const Lesson &lesson : library().lessons) {
    const View view = viewOnPaper({1600, 1000}, look.width, typeSize, theme);
    Drawing drawing = drawingOf(shapesOfStep(lesson, nullptr, view, theme), look);
    drawing.title = lesson.title;
    for (const ExportFormat &format : exportFormats())
      if (const auto problem = writeFile(folder / (lesson.id + format.ending),
                                         format.write(drawing, math::fonts(), TextAs::Shapes))) {
        std::fprintf(stderr, "%s\n", problem->text().c_str());
        return 1;
      }
  }
  return 0;
}

} // namespace
} // namespace halfspace

int main(int argc, char **argv) {
  if (argc != 2) {
    std::fputs("Say which folder the figures go into.\n", stderr);
    return 2;
  }
  return halfspace::writeFiguresInto(argv[1]);
}
