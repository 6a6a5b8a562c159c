#include "lessons/lesson/chapter_formulas.h"

#include <algorithm>
#include <utility>

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
    auto chapter = std::find_if(chapters.begin(), chapters.end(),
                                [&](const ChapterFormulas &each) { return each.chapter == lesson.chapter; });
    if (chapter == chapters.end())
      chapter = chapters.insert(chapters.end(), {lesson.chapter, {}});
    chapter->lessons.push_back(std::move(kept));
  }
  return chapters;
}

} // namespace halfspace
