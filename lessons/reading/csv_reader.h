// Tables of comma-separated values, as spreadsheets write them. Source: RFC 4180.
#pragma once

#include "lessons/result.h"

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace halfspace {

/// The cells of a row, without the white space at their ends and without the quotes around them.
struct CsvRow {
  std::vector<std::string> cells;
  int line = 0; ///< that it begins in, counted from 1
};

/// Takes a text apart row by row. What parts the cells is told by the first row: a semicolon or a tab where
/// it has one outside of quotes, else a comma. Lines end by \n, \r\n or \r; a cell in quotes may hold such
/// ends and separators, and quotes that are doubled.
class CsvReader {
public:
  /// `file` is only named in problems. The text, which must outlive the reader, is one (`firstNoText`).
  CsvReader(std::string_view text, std::string file);

  /// The next row in which anything stands; nothing at the end. A problem where quotes are open at the end or
  /// something stands behind them, and for more than `mostCsvCells` cells or a cell of more than
  /// `maxFieldText` bytes.
  [[nodiscard]] Result<std::optional<CsvRow>> next();

  [[nodiscard]] char separator() const { return m_separator; }

private:
  [[nodiscard]] Result<CsvRow> row();
  [[nodiscard]] Result<std::string> cell();
  [[nodiscard]] Result<std::string> quotedCell();
  [[nodiscard]] std::string plainCell();
  /// Takes the end of a line, if one stands here.
  bool takeLineEnd();
  void skipBlanks();
  [[nodiscard]] bool isAt(char c) const { return !m_rest.empty() && m_rest.front() == c; }
  [[nodiscard]] bool isAtCellEnd() const;
  [[nodiscard]] Problem problemAt(int line, std::string sentence) const {
    return {std::move(sentence), m_file, line, ""};
  }

  std::string_view m_rest;
  std::string m_file;
  char m_separator;
  int m_line = 1;
};

inline constexpr std::size_t mostCsvCells = 200;

} // namespace halfspace
