// Whatever the bytes: a lesson whose every step can be shown, or a problem with a sentence.
#include "lessons/lesson/filled_markdown.h"
#include "lessons/lesson/lesson_words.h"
#include "lessons/lesson/prose.h"
#include "lessons/lesson/shown.h"
#include "lessons/scene/session.h"

#include <cstdint>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  using namespace halfspace;
  const std::string_view text(reinterpret_cast<const char *>(data), size);
  const auto lesson = parseLesson(text, "fuzz");
  if (!lesson) {
    if (lesson.problem().sentence.empty() || lesson.problem().file != "fuzz")
      std::abort();
    return 0;
  }
  if (lesson->steps.empty())
    std::abort();
  const Evaluation outcome = evaluate(lesson->scene);
  for (const LessonWords &words : wordsOf(*lesson)) {
    const FilledMarkdown filled = filledIn(words.text.markdown(), [&](const std::string &name) {
      return liveValue(name, lesson->scene, outcome);
    });
    for (const FilledFormula &formula : filled.formulas)
      (void)plainText(formula, lesson->macros);
    (void)plainProse(words.text.written(), lesson->macros);
  }
  for (const LessonStep &step : lesson->steps) {
    if (predictionOf(step))
      (void)shownIn(step, outcome, Question::Open);
    (void)shownIn(step, outcome);
    for (const Task &task : tasksOf(step))
      (void)isDone(task, outcome);
  }
  return 0;
}
