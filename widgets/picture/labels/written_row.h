// Which numbers of an axis are written where there is no room for all of them.
#pragma once

#include "widgets/picture/labels/label_options.h"

namespace halfspace {

/// A number in a row of them.
struct RowNumber {
  int place = 0; ///< counted from the row's beginning
  PixelBox room; ///< that it takes on the screen
  bool canBeRead = true;
};

/// Of numbers in a row, in its order, which of them are written: each; or else every second, fifth or tenth,
/// and so on, counted from the row's beginning, so that no two neighbours take the same room. They are even
/// fewer where then all of them can be read, as long as two are left; else those are left out that cannot be
/// read.
[[nodiscard]] std::vector<bool> writtenOf(const std::vector<RowNumber> &row);

} // namespace halfspace
