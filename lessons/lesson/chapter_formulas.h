// The formulas of a chapter, as one page.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// What is to be kept of a lesson: the formulas blocks of its steps, in their order.
struct LessonFormulas {
  std::string lesson; ///< its id
  std::string title;
  std::vector<MarkdownText> formulas;
  bool operator==(const LessonFormulas &) const = default;
};

struct ChapterFormulas {
  std::string chapter;
  std::vector<LessonFormulas> lessons;
  bool operator==(const ChapterFormulas &) const = default;
};

/// The chapters of a library in their order, each once, with those of their lessons that have formulas; a
/// chapter without any is left out.
[[nodiscard]] std::vector<ChapterFormulas> formulasOf(const LessonLibrary &library);

} // namespace halfspace
