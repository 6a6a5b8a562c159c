// The markup of a lesson file, line by line: fences of blocks, and what looks like the heading of a step.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace halfspace {

/// Stands in a block of lines that shows none, in the place of their ids.
inline constexpr std::string_view noLines = "none";
/// Stands in a block of drawn marks that draws as Explore does, likewise.
inline constexpr std::string_view allMarks = "all";

/// A text's lines with their numbers, without their ends.
class LineScanner {
public:
  LineScanner(std::string_view text, int firstLine) : m_rest(text), m_number(firstLine - 1) {}

  bool next();
  [[nodiscard]] std::string_view line() const { return m_line; }
  [[nodiscard]] int number() const { return m_number; }
  [[nodiscard]] std::string_view rest() const { return m_rest; }

private:
  std::string_view m_rest;
  std::string_view m_line;
  int m_number;
};

/// The run of ``` or ~~~ that opens or closes a block of code here; empty when there is none.
[[nodiscard]] std::string_view fenceOf(std::string_view line);

/// What stands behind the fence of a line that has one: `task`.
[[nodiscard]] std::string_view wordOfFence(std::string_view line);

/// Whether a line ends the block that a fence has opened.
[[nodiscard]] bool closes(std::string_view line, std::string_view opening);

/// The title of the step that begins here.
[[nodiscard]] std::optional<std::string> stepTitle(std::string_view line);

/// What is wrong with a line where a step was perhaps to begin, but none does: `# Title`, `##Title`; else
/// empty.
[[nodiscard]] std::string whyNoStep(std::string_view line);

} // namespace halfspace
