// The fields of a lesson file: its front matter and its blocks.
#pragma once

#include "lessons/lesson/lesson.h"

namespace halfspace {

/// A block of a file with the line that it begins at.
struct TextBlock {
  std::string text;
  int firstLine = 1;
};

/// Reads the front matter into a lesson without steps.
[[nodiscard]] Result<Lesson> readFrontMatter(const TextBlock &block, const std::string &file);

/// Reads a ```task block.
[[nodiscard]] Result<Task> readTask(const TextBlock &block, const std::string &file);

/// Reads a ```predict block.
[[nodiscard]] Result<Prediction> readPrediction(const TextBlock &block, const std::string &file);

/// Reads a ```flight block.
[[nodiscard]] Result<StepFlight> readFlight(const TextBlock &block, const std::string &file);

/// Reads a ```fragments block.
[[nodiscard]] Result<StepFragments> readFragments(const TextBlock &block, const std::string &file);

/// Reads a ```cost block.
[[nodiscard]] Result<StepCost> readCost(const TextBlock &block, const std::string &file);

/// Reads a ```term block.
[[nodiscard]] Result<TaughtTerm> readTerm(const TextBlock &block, const std::string &file);

/// Reads a ```lines block: ids between commas or spaces.
[[nodiscard]] Result<StepLines> readLines(const TextBlock &block, const std::string &file);

/// Reads a ```draw block: likewise, or `all`, into what the step draws.
[[nodiscard]] std::optional<Problem> readMarkIds(const TextBlock &block, const std::string &file,
                                                 LessonStep &step);

/// Reads a ```hide block: names of entries likewise, into what the step hides.
[[nodiscard]] std::optional<Problem> readHidden(const TextBlock &block, const std::string &file,
                                                LessonStep &step);

/// Reads a ```blank block: none, gaps, last or all.
[[nodiscard]] Result<Fading> readFading(const TextBlock &block, const std::string &file);

} // namespace halfspace
