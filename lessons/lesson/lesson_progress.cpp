#include "lessons/lesson/lesson_progress.h"

#include <algorithm>

namespace halfspace {
namespace {

bool isDone(const LessonStep &step, const StepProgress &progress) {
  const std::vector<bool> &tasks = progress.tasks.done();
  const std::size_t count = tasksOf(step).size();
  return (!predictionOf(step) || progress.chosen) && tasks.size() >= count &&
         std::all_of(tasks.begin(), tasks.begin() + static_cast<std::ptrdiff_t>(count),
                     [](bool done) { return done; });
}

bool asks(const LessonStep &step) { return predictionOf(step) || !tasksOf(step).empty(); }

bool isBegun(const StepProgress &progress) {
  const std::vector<bool> &tasks = progress.tasks.done();
  return progress.chosen || std::find(tasks.begin(), tasks.end(), true) != tasks.end();
}

TaskProgress merged(const TaskProgress &first, const TaskProgress &second) {
  std::vector<bool> done(std::max(first.done().size(), second.done().size()));
  for (const TaskProgress *each : {&first, &second})
    for (std::size_t i = 0; i < each->done().size(); ++i)
      done[i] = done[i] || each->done()[i];
  return TaskProgress(std::move(done));
}

void mergeInto(StepProgress &both, const StepProgress &step) {
  if (!both.chosen) {
    both.chosen = step.chosen;
    both.right = step.right;
  }
  both.tasks = merged(both.tasks, step.tasks);
}

/// The name of a step that is told by its number; the number itself where no lesson has such a step.
StepId byName(const std::string &lessonId, const StepId &step, const std::vector<Lesson> &lessons) {
  const auto lesson = std::ranges::find(lessons, lessonId, &Lesson::id);
  const int *number = std::get_if<int>(&step);
  const bool isThere = number && lesson != lessons.end() && *number >= 0 &&
                       static_cast<std::size_t>(*number) < lesson->steps.size();
  return isThere ? StepId(nameOfStep(*lesson, *number)) : step;
}

} // namespace

LessonState stateOf(const Lesson &lesson, const LessonProgress &progress) {
  bool begun = false;
  bool all = true;
  bool any = false;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const auto found = progress.find({lesson.id, nameOfStep(lesson, static_cast<int>(i))});
    const StepProgress step = found == progress.end() ? StepProgress() : found->second;
    begun = begun || isBegun(step);
    any = any || asks(lesson.steps[i]);
    all = all && (!asks(lesson.steps[i]) || isDone(lesson.steps[i], step));
  }
  return any && all ? LessonState::Done : begun ? LessonState::Begun : LessonState::New;
}

LessonProgress merged(LessonProgress first, const LessonProgress &second) {
  for (const auto &[place, step] : second)
    mergeInto(first[place], step);
  return first;
}

std::string nameOfStep(const Lesson &lesson, int step) {
  const std::string &title = stepOf(lesson, step).title;
  const auto before = lesson.steps.begin() + std::min(step, static_cast<int>(lesson.steps.size()));
  const auto same = std::ranges::count(lesson.steps.begin(), before, title, &LessonStep::title);
  return same == 0 ? title : title + "\n" + std::to_string(same);
}

LessonProgress withStepNames(const LessonProgress &progress, const std::vector<Lesson> &lessons) {
  LessonProgress renamed;
  for (const auto &[place, step] : progress)
    mergeInto(renamed[{place.first, byName(place.first, place.second, lessons)}], step);
  return renamed;
}

} // namespace halfspace
