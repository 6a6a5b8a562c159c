// The formulas of a chapter, as one page.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// What is to be kept of a lesson: the formulas blocks of its steps, in their order.
struct LessonFormulas {
  std::string lesson; ///< its id
  std::string title;
  std::vector<MarkdownText> formulas;
};

struct ChapterFormulas {
  std::string chapter; ///< empty for lessons that name none
  std::vector<LessonFormulas> lessons;
};

/// The chapters of a library in their order, with those of their lessons that have formulas; a chapter
/// without any is left out.
[[nodiscard]] std::vector<ChapterFormulas> formulasOf(const LessonLibrary &library);

} // namespace halfspace
