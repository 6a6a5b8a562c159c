#include "lessons/lesson/lesson_words.h"

#include <algorithm>
#include <utility>

namespace halfspace {

int LessonWords::lineAt(std::size_t place) const {
  const std::string &written = text.written();
  const auto end = written.begin() + static_cast<std::ptrdiff_t>(std::min(place, written.size()));
  const auto passed = std::count(written.begin(), end, '\n');
  return lines.empty() ? 0 : lines[std::min(static_cast<std::size_t>(passed), lines.size() - 1)];
}

LessonWords::LessonWords(MarkdownText words, std::vector<int> linesOfWords, std::string fieldOfWords)
    : text(std::move(words)), lines(std::move(linesOfWords)), field(std::move(fieldOfWords)) {}

namespace {

LessonWords ofPage(const StepWords &block, const std::string &field) {
  LessonWords words(block.text, block.lines, field);
  words.showsPictures = true;
  return words;
}

/// Of what fills in no values.
LessonWords withoutValues(const MarkdownText &text, int line, const std::string &field) {
  LessonWords words(text, {line}, field);
  words.fillsInValues = false;
  return words;
}

/// Of what is kept beside the lesson.
LessonWords besidePage(const MarkdownText &text, std::vector<int> lines, const std::string &field) {
  LessonWords words(text, std::move(lines), field);
  words.fillsInValues = false;
  words.isOnPage = false;
  return words;
}

} // namespace

std::vector<LessonWords> wordsOf(const LessonStep &step) {
  std::vector<LessonWords> words;
  const Overloaded add{[&](const StepWords &block) { words.push_back(ofPage(block, "")); },
                       [](const StepLines &) {},
                       [](const StepFlight &) {},
                       [](const StepFragments &) {},
                       [](const StepCost &) {},
                       [&](const StepNote &note) { words.push_back(ofPage(note.words, "note")); },
                       [&](const Task &task) {
                         words.emplace_back(task.instruction, std::vector{task.line}, "do");
                         if (!task.now.isEmpty())
                           words.emplace_back(task.now, std::vector{task.nowLine}, "now");
                         for (const Task::Hint &hint : task.hints)
                           words.emplace_back(hint.text, std::vector{hint.line}, "hints");
                         if (!task.answer.isEmpty())
                           words.emplace_back(task.answer, std::vector{task.answerLine}, "done");
                       },
                       [&](const Prediction &prediction) {
                         words.push_back(withoutValues(prediction.question, prediction.questionLine, "ask"));
                         for (const Prediction::Choice &choice : prediction.choices)
                           words.push_back(withoutValues(choice.text, choice.line, "choices"));
                         words.push_back(withoutValues(prediction.reason, prediction.reasonLine, "why"));
                       }};
  for (const StepBlock &block : step.blocks)
    std::visit(add, block);
  for (const TaughtTerm &term : step.terms)
    words.push_back(besidePage(term.meaning, {term.meaningLine}, "means"));
  for (const StepWords &formulas : step.formulas)
    words.push_back(besidePage(formulas.text, formulas.lines, "formulas"));
  return words;
}

std::vector<LessonWords> wordsOf(const Lesson &lesson) {
  std::vector<LessonWords> words;
  for (const LessonStep &step : lesson.steps)
    for (LessonWords &piece : wordsOf(step))
      words.push_back(std::move(piece));
  return words;
}

} // namespace halfspace
