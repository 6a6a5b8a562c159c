// All words of a lesson that are set with their formulas, in one list.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// A piece of a lesson's words.
struct LessonWords {
  LessonWords(MarkdownText words, std::vector<int> linesOfWords, std::string fieldOfWords);

  MarkdownText text;
  std::vector<int> lines;     ///< where its lines stand in the file; one for all where YAML has folded them
  std::string field;          ///< of a block; empty for the words of a step
  bool showsPictures = false; ///< see StepWords
  bool fillsInValues = true;  ///< see Prediction
  /// It stands on the page of its step; else in the glossary or among the formulas of a chapter, where the
  /// macros of the lesson are not known.
  bool isOnPage = true;

  /// The line of the file that a place in the text is of.
  [[nodiscard]] int lineAt(std::size_t place) const;
};

/// From top to bottom within a step.
[[nodiscard]] std::vector<LessonWords> wordsOf(const LessonStep &step);
[[nodiscard]] std::vector<LessonWords> wordsOf(const Lesson &lesson);

} // namespace halfspace
