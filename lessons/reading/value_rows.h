// Rows of values for a scene's coordinates, from files that spreadsheets and scripts write.
#pragma once

#include "lessons/result.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace halfspace {

/// A value of a row, spelled as `--set` takes it.
struct ColumnValue {
  std::size_t column = 0;
  std::string value;
};

struct ValueRow {
  std::vector<ColumnValue> values; ///< without what is left empty
  int line = 0;                    ///< of the file, counted from 1
};

struct ValueRows {
  std::string file;                 ///< named in problems
  std::vector<std::string> columns; ///< their names, each once
  std::vector<ValueRow> rows;       ///< at least one

  /// Nothing where there is no such column.
  [[nodiscard]] std::optional<std::size_t> columnOf(std::string_view name) const;
  /// What a row has in a column; empty for nothing.
  [[nodiscard]] std::string valueIn(std::size_t row, std::size_t column) const;
};

/// Reads a stranger's table of at most `maxRowsBytes`: JSON Lines where it begins with a brace, an object a
/// line, whose values are texts, numbers or lists of both; else CSV, whose first row has the names of the
/// columns. A byte order mark before it is passed over. In a CSV file with semicolons the comma is a decimal
/// mark where it stands alone in a cell (1,5), and where semicolons part the numbers of a cell in quotes.
[[nodiscard]] Result<ValueRows> readValueRows(std::string_view text, const std::string &file);

inline constexpr std::size_t maxRowsBytes = 8U << 20U;
inline constexpr std::size_t mostRows = 100'000;
inline constexpr std::size_t mostColumns = 200;

} // namespace halfspace
