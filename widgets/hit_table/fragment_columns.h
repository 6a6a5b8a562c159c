// Where the columns of a table of fragments are.
#pragma once

#include <QRectF>

#include <array>

namespace halfspace {

/// What its columns need, in pixels; it does not depend on the numbers, which change while a ray is dragged.
struct FragmentNeeds {
  double line = 0;    ///< the height of a line of words
  double name = 0;    ///< of the widest name
  double number = 0;  ///< of a number as wide as they get; narrower columns make them smaller
  double verdict = 0; ///< of the longest verdict
  bool operator==(const FragmentNeeds &) const = default;
};

struct FragmentColumns {
  struct Column {
    double left = 0;
    double width = 0;
  };
  double mark = 0; ///< the middle of the marks before the names
  Column name;
  std::array<Column, 3> numbers; ///< t, s and t of the triangle
  Column verdict;
  /// The numbers stand in a second line, below the name and, at the right end, the verdict: these two share
  /// the first.
  bool isStacked = false;
  double width = 0; ///< of the whole table
  double rowHeight = 0;

  /// Lines of a row that begins at y = 0: their middles.
  [[nodiscard]] double wordsMiddle() const;
  [[nodiscard]] double numbersMiddle() const;
};

[[nodiscard]] FragmentColumns columnsIn(double width, const FragmentNeeds &needs);

} // namespace halfspace
