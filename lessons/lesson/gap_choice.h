// Which number of a worked line is left out of it.
#pragma once

#include "lessons/lesson/practice.h"

namespace halfspace {

/// Every number and every list in the sides of a chain that are calculated.
[[nodiscard]] std::vector<Gap> numberGaps(const Chain &chain);

/// One of the numbers of a line to be worked out, which is shown with the lines of this working: not the same
/// of all lines, but the same of a line that is built alike, so that it stays where it is while the scene
/// moves. None that is written anywhere else, and none that the line says nothing of: in 0·? = 0 every number
/// is right. Nothing where no number is left.
[[nodiscard]] std::optional<Gap> gapAmongNumbers(const WorkingLine &line, const Working &working);

} // namespace halfspace
