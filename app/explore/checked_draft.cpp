#include "app/explore/checked_draft.h"

#include "app/check.h"
#include "lessons/lesson/write_lesson.h"

#include <utility>

namespace halfspace {

CheckedDraft checked(const LessonDraft &draft, const Scene &scene, const CameraView &camera,
                     const std::string &file) {
  if (auto problems = problemsOf(draft); !problems.empty())
    return {"", std::move(problems)};
  WrittenLesson written = writeLesson(draft, scene, camera);
  CheckedDraft result;
  const auto keep = [&](const Problem &problem) {
    result.problems.push_back({written.stepAt(problem.line), problem.sentence});
  };
  if (const auto lesson = parseLesson(written.text, file); !lesson)
    keep(lesson.problem());
  else
    for (const Problem &problem : problemsIn(*lesson))
      keep(problem);
  result.text = std::move(written.text);
  return result;
}

} // namespace halfspace
