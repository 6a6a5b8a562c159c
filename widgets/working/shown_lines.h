// What a block shows of a step's working, and what it leaves to the learner.
#pragma once

#include "lessons/construction/line_text.h"
#include "lessons/lesson/practice.h"

#include <QString>

namespace halfspace {

/// Lines of a working: [begin, end).
struct LineRange {
  std::size_t begin = 0;
  std::size_t end = static_cast<std::size_t>(-1); ///< at most the last line
};

/// Some lines of a working, as they are to be read: what is left out of them is in none of its texts.
class ShownLines {
public:
  ShownLines() = default;
  ShownLines(Working working, LineRange range, Fade fade);

  [[nodiscard]] const std::vector<WorkingLine> &lines() const { return m_lines; }
  /// What is left out of a line; null when nothing is.
  [[nodiscard]] const Gap *gapOf(const std::string &lineId) const;
  /// Whether a line does not tell all that it says.
  [[nodiscard]] bool hides(const std::string &lineId) const;
  /// What is told beside a line's gap, as no line of the step's working says it.
  [[nodiscard]] std::vector<Chain> toldFor(const WorkingLine &line, const Gap &gap) const;

  /// The lines to be read aloud, one below the other.
  [[nodiscard]] QString spoken() const;
  /// The lines as they may be taken elsewhere; this must outlive them.
  [[nodiscard]] std::vector<ToldLine> told() const;

private:
  [[nodiscard]] std::string spokenOf(const WorkingLine &line) const;

  Working m_working; ///< of the step
  Fade m_fade;
  std::vector<WorkingLine> m_lines;
};

} // namespace halfspace
