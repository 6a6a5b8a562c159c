#include "lessons/lesson/chapter_formulas.h"

namespace halfspace {
namespace {

LessonFormulas formulasOf(const Lesson &lesson) {
  LessonFormulas kept{lesson.id, lesson.title, {}};
  for (const LessonStep &step : lesson.steps)
    for (const StepWords &formulas : step.formulas)
      kept.formulas.push_back(formulas.text);
  return kept;
}

} // namespace

std::vector<ChapterFormulas> formulasOf(const LessonLibrary &library) {
  std::vector<ChapterFormulas> chapters;
  for (const Lesson &lesson : library.lessons) {
    LessonFormulas kept = formulasOf(lesson);
    if (kept.formulas.empty())
      continue;
    if (chapters.empty() || chapters.back().chapter != lesson.chapter)
      chapters.push_back({lesson.chapter, {}});
    chapters.back().lessons.push_back(std::move(kept));
  }
  return chapters;
}

} // namespace halfspace
