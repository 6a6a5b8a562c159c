// Which fragments a table shows, and in which order.
#pragma once

#include "lessons/lesson/lesson.h"
#include "lessons/lesson/live_values.h"
#include "widgets/flight/crossing_look.h"

#include <optional>
#include <vector>

namespace halfspace {

struct FragmentRow {
  Crossing crossing;
  Standing standing = Standing::NotAsked;
  bool beginsRay = false; ///< those above it lie behind the ray's start, it does not
};

struct FragmentRows {
  std::vector<FragmentRow> rows;
  std::size_t leftOut = 0;        ///< how many fragments have no row
  bool leftOutAreOutside = false; ///< all of them
};

/// At most so many rows: first the chosen and the nearest, then hits, then what else the ray crosses, the
/// nearest to its start first. They stand in the order of the crossings, behind them by number those that are
/// not asked yet; all by number where values are hidden, so that their order tells nothing.
[[nodiscard]] FragmentRows rowsOf(const Crossings &crossings, LiveValues values, std::size_t most);

/// The row of the fragment with this number; nothing where it has none.
[[nodiscard]] std::optional<std::size_t> rowOf(const FragmentRows &shown, std::size_t number);

/// Whether the numbers of a row are not to be seen.
[[nodiscard]] inline bool hidesNumbers(const FragmentRow &row, LiveValues values) {
  return values == LiveValues::Hidden || row.standing == Standing::NotAsked;
}

} // namespace halfspace
