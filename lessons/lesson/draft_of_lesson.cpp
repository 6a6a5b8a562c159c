#include "lessons/lesson/draft_of_lesson.h"

#include "lessons/lesson/condition.h"
#include "lessons/lesson/lesson_markup.h"
#include "lessons/lesson/write_lesson.h"

namespace halfspace {
namespace {

DraftQuestion draftOf(const Prediction &prediction) {
  DraftQuestion question{prediction.question.written(), prediction.value, {}, prediction.reason.written()};
  for (const Prediction::Choice &choice : prediction.choices)
    question.choices.push_back({choice.word, choice.text.written()});
  return question;
}

/// The constructions of which all lines are shown.
std::vector<std::string> workingsIn(const StepLines &lines) {
  std::vector<std::string> names;
  for (const std::string &id : lines.ids)
    if (id != noLines)
      names.push_back(entryOf(id));
  return names;
}

/// What a draft has no word for is left out.
DraftStep draftOf(const LessonStep &step) {
  DraftStep draft{step.title, ""};
  draft.hidden = step.hidden;
  for (const StepBlock &block : step.blocks)
    if (const auto *words = std::get_if<StepWords>(&block))
      draft.words = words->text.written();
    else if (const auto *prediction = std::get_if<Prediction>(&block))
      draft.question = draftOf(*prediction);
    else if (const auto *task = std::get_if<Task>(&block))
      draft.task = DraftTask{task->instruction.written(), toText(task->conditions)};
    else if (const auto *lines = std::get_if<StepLines>(&block))
      draft.workings = workingsIn(*lines);
  return draft;
}

} // namespace

std::optional<LessonDraft> draftOf(const Lesson &lesson) {
  if (lesson.order != 0)
    return {}; // a draft has no place in a course, and nothing more need be read of those that have
  LessonDraft draft{lesson.id, lesson.title, {}};
  for (const LessonStep &step : lesson.steps)
    draft.steps.push_back(draftOf(step));
  const bool isAll =
      problemsOf(draft).empty() && writeLesson(draft, lesson.scene, lesson.camera).text == lesson.text;
  return isAll ? std::optional(std::move(draft)) : std::nullopt;
}

} // namespace halfspace
