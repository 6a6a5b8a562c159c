#include "widgets/hit_table/fragment_columns.h"

#include <algorithm>

namespace halfspace {
namespace {

// In heights of a line.
constexpr double edge = 0.3; ///< left and right of a row's words
constexpr double markRoom = 1.05;
constexpr double smallestGap = 0.45;
constexpr double largestGap = 2;
constexpr double verdictGap = 0.45; ///< on top of that, before the verdict
constexpr double rowHeight = 1.6;
constexpr double stackedRowHeight = 2.9;

/// A number's column is at least this part of what the widest number needs.
constexpr double narrowestNumber = 0.62;

/// Where each column is as narrow as it may be, but for the gaps.
double narrowestWidth(const FragmentNeeds &needs) {
  return (2 * edge + markRoom + verdictGap) * needs.line + needs.name + 3 * narrowestNumber * needs.number +
         needs.verdict;
}

FragmentColumns inOneLine(double width, const FragmentNeeds &needs) {
  FragmentColumns columns;
  double spare = width - narrowestWidth(needs) - 4 * smallestGap * needs.line;
  const double widening = std::min(spare / 3, (1 - narrowestNumber) * needs.number);
  const double number = narrowestNumber * needs.number + widening;
  spare -= 3 * widening;
  const double gap = std::min(smallestGap * needs.line + spare / 4, largestGap * needs.line);
  columns.name = {(edge + markRoom) * needs.line, needs.name};
  double left = columns.name.left + needs.name + gap;
  for (FragmentColumns::Column &column : columns.numbers) {
    column = {left, number};
    left += number + gap;
  }
  columns.verdict = {left + verdictGap * needs.line, needs.verdict};
  columns.width = columns.verdict.left + needs.verdict + edge * needs.line;
  columns.rowHeight = rowHeight * needs.line;
  return columns;
}

FragmentColumns inTwoLines(double width, const FragmentNeeds &needs) {
  FragmentColumns columns;
  columns.isStacked = true;
  columns.width = width;
  const double left = (edge + markRoom) * needs.line;
  const double right = width - edge * needs.line;
  const double gap = smallestGap * needs.line;
  columns.name = {left, std::max(0.0, right - left)};
  columns.verdict = columns.name; // from its right end
  const double third = std::max(0.0, right - left - 2 * gap) / 3;
  for (std::size_t i = 0; i < columns.numbers.size(); ++i)
    columns.numbers[i] = {left + static_cast<double>(i) * (third + gap), third};
  columns.rowHeight = stackedRowHeight * needs.line;
  return columns;
}

} // namespace

double FragmentColumns::wordsMiddle() const { return rowHeight * (isStacked ? 0.28 : 0.5); }

double FragmentColumns::numbersMiddle() const { return rowHeight * (isStacked ? 0.7 : 0.5); }

FragmentColumns columnsIn(double width, const FragmentNeeds &needs) {
  FragmentColumns columns = width >= narrowestWidth(needs) + 4 * smallestGap * needs.line
                                ? inOneLine(width, needs)
                                : inTwoLines(width, needs);
  columns.mark = (edge + markRoom * 0.38) * needs.line;
  return columns;
}

} // namespace halfspace
