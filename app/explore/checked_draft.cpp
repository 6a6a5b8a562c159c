#include "app/explore/checked_draft.h"

#include "app/check.h"
#include "lessons/lesson/write_lesson.h"
#include "lessons/words.h"

#include <utility>

namespace halfspace {
namespace {

/// What is wrong with the first task where the scene is as it asks from the start. Later ones may ask for
/// what was so once.
std::optional<DraftProblem> taskDoneAtStart(const Lesson &lesson, const Evaluation &start) {
  for (std::size_t step = 0; step < lesson.steps.size(); ++step)
    if (const std::vector<Task> tasks = tasksOf(lesson.steps[step]); !tasks.empty()) {
      if (isDone(tasks.front(), start))
        return DraftProblem{step, words("What the task asks is so already as the scene is now.")};
      return {};
    }
  return {};
}

} // namespace

CheckedDraft checked(const LessonDraft &draft, const Evaluation &start, const CameraView &camera,
                     const std::string &file) {
  if (auto problems = problemsOf(draft); !problems.empty())
    return {"", std::move(problems)};
  WrittenLesson written = writeLesson(draft, start.scene, camera);
  CheckedDraft result;
  const auto keep = [&](const Problem &problem) {
    result.problems.push_back({written.stepAt(problem.line), problem.sentence});
  };
  if (const auto lesson = parseLesson(written.text, file); !lesson) {
    keep(lesson.problem());
  } else {
    for (const Problem &problem : problemsIn(*lesson))
      keep(problem);
    if (auto problem = taskDoneAtStart(*lesson, start))
      result.problems.push_back(std::move(*problem));
  }
  result.text = std::move(written.text);
  return result;
}

} // namespace halfspace
