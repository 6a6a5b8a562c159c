// Writes the figures of all lessons' steps in every format into a folder, so that what was built by another
// compiler, or on another day, can be compared with it: scripts/check-same-figures.sh.
#include "tests/exports/lesson_drawings.h"
#include "widgets/exports/format.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

namespace halfspace {
namespace {

/// Whether all could be written.
bool writeFiguresInto(const std::filesystem::path &folder) {
  bool areWritten = !library().lessons.empty();
  for (const Lesson &lesson : library().lessons)
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
      const Drawing drawing = drawingOfStep(lesson, lesson.steps[i]);
      for (const ExportFormat &format : exportFormats()) {
        std::ofstream file(folder / (lesson.id + "-" + std::to_string(i + 1) + format.ending),
                           std::ios::binary);
        file << format.write(drawing, math::fonts(), TextAs::Shapes);
        areWritten = areWritten && file.flush();
      }
    }
  return areWritten;
}

} // namespace
} // namespace halfspace

int main(int argc, char **argv) {
  if (argc == 2 && halfspace::writeFiguresInto(argv[1]))
    return 0;
  std::fputs("Say which folder the figures go into, and let there be room for them.\n", stderr);
  return 2;
}
