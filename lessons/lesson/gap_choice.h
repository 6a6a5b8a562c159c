// Which number of a worked line is left out of it.
#pragma once

#include "lessons/construction/working.h"

#include <optional>
#include <vector>

namespace halfspace {

/// What is left out of a line.
struct Gap {
  Term hidden; ///< a number or a list in the line's chain; or the chain's last side, see `isResult`
  /// The chain ends in symbols: everything calculated is hidden along with the result.
  bool isResult = true;
  /// Of a number in a list: which one of those that its origin comes to.
  std::optional<std::size_t> entry{};
};

/// Every number and every list in the sides of a chain that are calculated: each can be left out alone.
[[nodiscard]] std::vector<Gap> numberGaps(const Chain &chain);

/// Chooses among the numbers of lines that are shown together, in a working that outlives the choice.
class GapChoice {
public:
  explicit GapChoice(const Working &working);

  /// One of the numbers of a line to be worked out: not the same of all lines, but the same of a line that is
  /// built alike, so that it stays where it is while the scene moves. None that is written anywhere else, and
  /// none that the line says nothing of: in 0·? = 0 every number is right. Nothing where no number is left.
  [[nodiscard]] std::optional<Gap> of(const WorkingLine &line) const;

private:
  const Working &m_working;
  std::vector<Gap> m_written; ///< every number of the working
};

} // namespace halfspace
