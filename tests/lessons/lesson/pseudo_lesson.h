// Lessons in the pseudo-language, so that what stands among their words in English is the program's.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/pseudo_language.h"

#include <regex>
#include <string>

namespace halfspace::test {

/// The words of a piece of Markdown, without its formulas and where its links and pictures lead to. Sections
/// of notes have no decimal points either: 3:5 for 3.5.
inline std::string pseudoWords(const std::string &written) {
  static const std::regex noWords("\\$\\$[^$]*\\$\\$|\\$[^$]*\\$|\\]\\([^)]*\\)");
  static const std::regex section("([0-9])[.]([0-9])");
  const std::string markdown = std::regex_replace(written, section, "$1:$2");
  std::string words;
  auto from = markdown.cbegin();
  for (std::sregex_iterator found(markdown.begin(), markdown.end(), noWords), end; found != end; ++found) {
    words += inPseudoLetters(std::string(from, (*found)[0].first));
    words += found->str();
    from = (*found)[0].second;
  }
  return words + inPseudoLetters(std::string(from, markdown.cend()));
}

namespace detail {

inline void translate(std::string &words) { words = pseudoWords(words); }
inline void translate(MarkdownText &words) { words = pseudoWords(words.written()); }

struct BlockTranslator {
  void operator()(StepWords &words) const { translate(words.text); }
  void operator()(StepNote &note) const {
    translate(note.title);
    translate(note.words.text);
  }
  void operator()(Task &task) const {
    for (MarkdownText *words : {&task.instruction, &task.now, &task.answer})
      translate(*words);
    for (Task::Hint &hint : task.hints)
      translate(hint.text);
  }
  void operator()(Prediction &prediction) const {
    translate(prediction.question);
    translate(prediction.reason);
    for (Prediction::Choice &choice : prediction.choices)
      translate(choice.text);
  }
  void operator()(const auto & /*hasNoWords*/) const {}
};

} // namespace detail

inline LessonLibrary inPseudoLanguage(LessonLibrary library) {
  for (Lesson &lesson : library.lessons) {
    detail::translate(lesson.title);
    detail::translate(lesson.chapter);
    for (std::string &source : lesson.sources)
      detail::translate(source);
    for (LessonStep &step : lesson.steps) {
      for (StepWords &formulas : step.formulas)
        detail::translate(formulas.text);
      detail::translate(step.title);
      for (StepBlock &block : step.blocks)
        std::visit(detail::BlockTranslator(), block);
    }
  }
  return library;
}

} // namespace halfspace::test
