#include "lessons/lesson/explore.h"

#include "lessons/lesson/lesson_markup.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// A view in which the ground reaches from corner to corner, and all three axes are seen.
const CameraView usualView{{1.25, -0.9, 0.8}, {0, 0, 1}, 14};

/// What pages and files have of it: the lines of the last constructions, and what comes out of all.
LessonStep onlyStep() {
  LessonStep step{words("Your own scene"), {StepLines()}};
  step.drawsAllResults = true;
  return step;
}

Lesson madeLesson() {
  Lesson lesson;
  lesson.id = exploreId;
  lesson.title = words("Explore");
  lesson.camera = usualView;
  lesson.steps = {onlyStep()};
  return lesson;
}

} // namespace

const Lesson &exploreLesson() {
  static const Lesson lesson = madeLesson();
  return lesson;
}

LessonStep stepShowing(const std::vector<std::string> &constructions) {
  StepLines lines;
  for (const std::string &name : constructions)
    lines.ids.push_back(name + ".*");
  if (lines.ids.empty())
    lines.ids.emplace_back(noLines);
  LessonStep step{{}, {std::move(lines)}};
  step.drawsAllResults = true;
  return step;
}

} // namespace halfspace
