// Figures of vectors: what drawing and writing one costs, and how large it is.
#include "tests/bench/durations.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/timed_command.h"
#include "tests/handout/handouts.h"
#include "widgets/exports/format.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

namespace halfspace::bench {
namespace {

constexpr double mostMilliseconds = 20;
constexpr double mostKilobytes = 40;
constexpr double leastFiguresASecond = 50;
constexpr double mostHandoutMilliseconds = 500;
constexpr int rounds = 15;

/// The whole figure of a lesson: the median of its times, from its shapes to the file.
void measureLargest(const Lesson &lesson, const ExportFormat &format) {
  const Theme &theme = *findTheme("print");
  const PaperLook look;
  const ShapeList shapes =
      shapesOfStep(lesson, nullptr, viewOnPaper({1600, 1000}, look.width, 9, theme), theme);
  Durations durations;
  std::size_t bytes = 0;
  for (int i = 0; i < rounds; ++i) {
    const auto start = Clock::now();
    bytes = format.write(drawingOf(shapes, look), math::fonts(), TextAs::Shapes).size();
    durations.add(millisecondsSince(start));
  }
  printGoal(format.name + " of " + lesson.id + ", ms", durations.median(), mostMilliseconds);
  if (format.name == "PDF")
    printGoal("its KB", static_cast<double>(bytes) / 1024, mostKilobytes);
}

/// All steps of all lessons one after the other, from their scenes to the files.
void measureBatch(const ExportFormat &format) {
  std::size_t figures = 0;
  const auto start = Clock::now();
  for (const Lesson &lesson : library().lessons)
    for (const LessonStep &step : lesson.steps)
      figures += format.write(drawingOfStep(lesson, step), math::fonts(), TextAs::Shapes).empty() ? 0U : 1U;
  printLeast(format.name + " of all steps, figures a second",
             1000 * static_cast<double>(figures) / millisecondsSince(start), leastFiguresASecond);
}

/// The same by the command, from its start to its end.
void measureCommand(const ExportFormat &format) {
  const BenchFolder folder("figures");
  const auto time = timeOfCommand(
      "render --all --steps -o '{lesson}-{step}" + format.ending + "' 2>/dev/null", folder.path());
  const auto figures = std::distance(std::filesystem::directory_iterator(folder.path()), {});
  printLeast(format.name + " by `halfspace render --all --steps`, figures a second",
             time ? 1000 * static_cast<double>(figures) / *time : 0, leastFiguresASecond);
}

/// The longest lesson as a handout, from its words to the file: the median of its times.
void measureHandout() {
  const auto longest =
      std::max_element(library().lessons.begin(), library().lessons.end(),
                       [](const Lesson &a, const Lesson &b) { return a.text.size() < b.text.size(); });
  const WholeHandout handout(*longest);
  Durations durations;
  for (int i = 0; i < rounds; ++i) {
    const auto start = Clock::now();
    if (handoutOf(handout.request(), handoutFonts()).empty())
      return;
    durations.add(millisecondsSince(start));
  }
  printGoal("handout of " + longest->id + ", ms", durations.median(), mostHandoutMilliseconds);
}

int run() {
  std::printf("\nfigures of vectors\n");
  for (const ExportFormat &format : exportFormats()) {
    measureLargest(*library().find("photon-torpedo"), format);
    measureBatch(format);
    measureCommand(format);
  }
  measureHandout();
  return library().lessons.empty() ? 1 : 0;
}

} // namespace
} // namespace halfspace::bench

int main() { return halfspace::bench::run(); }
