// Breaks a formula that is too wide the way teachers do at the board.
#pragma once

#include "widgets/formula/layout.h"

namespace halfspace::math {

/// Lengths in em.
struct LineRules {
  double width = 0;  ///< no line is wider where it can be broken
  double indent = 2; ///< where the second line begins, unless it can be set below the first relation
  double gap = 0.4;  ///< between the lowest of a line and the highest of the next
  bool belowRelation =
      true; ///< begin a line with a relation below the first line's first, if that stands far left
};

/// Breaks between statements that a wide space sets apart (the next begins at the left again), before
/// relations, else before + and −, else before other operations; behind a side on several lines the next
/// relation begins one; inside parentheses only when there is no
/// other way, behind a comma wherever there is one that fits, and never inside a fraction or between \left
/// and \right. What is narrow enough stays as it is.
[[nodiscard]] Layout breakLines(Layout layout, const LineRules &rules);

} // namespace halfspace::math
