// Where the lines of a paragraph end.
#pragma once

#include <cstddef>
#include <vector>

namespace halfspace {

/// What stays together in a line: a word, a formula.
struct BreakItem {
  double width = 0;
  double space = 0;       ///< before it, where it does not begin a line
  bool mayBegin = true;   ///< whether a line may begin with it
  bool mustBegin = false; ///< whether one must
};

enum class LineEnds { Ragged, Justified };

/// The first item of each line, so that all lines together are as even as can be, and not one after the
/// other. No line is wider than the width, unless an item, or items that must not be parted, are; spaces of
/// justified lines may become somewhat narrower.
[[nodiscard]] std::vector<std::size_t> lineStarts(const std::vector<BreakItem> &items, double width,
                                                  LineEnds ends);

/// How much narrower a space of a justified line may become, as part of its width.
inline constexpr double mostShrinking = 0.2;

} // namespace halfspace
