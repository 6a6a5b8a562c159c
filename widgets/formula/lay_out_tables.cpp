// Matrices, cases and aligned formulas.
#include "widgets/formula/set.h"

#include <algorithm>
#include <vector>

namespace halfspace::math {
namespace {

/// How a kind of table is set; lengths in em.
struct Spacing {
  double columnGap = 1;
  double rowHeight = 1.2; ///< of a row of single letters
  double rowGap = 0.1;    ///< at least, between the ink of two rows
  double edge = 0;        ///< to the left and right of all columns
  Style cellStyle = Style::Text;
};

/// LaTeX's, with more room between rows and inside brackets: there tall entries touch each other, and bars
/// the entries.
Spacing spacingOf(TableKind kind) {
  switch (kind) {
  case TableKind::Matrix:
    return {1, 1.3, 0.2, 0.1, Style::Text};
  case TableKind::Cases:
    return {1, 1.3, 0.2, 0, Style::Text};
  case TableKind::SmallMatrix:
    return {0.28, 0.8, 0.05, 0.05, Style::Script};
  case TableKind::Aligned:
    return {2, 1.5, 0.4, 0, Style::Display};
  case TableKind::Gathered:
    return {1, 1.5, 0.4, 0, Style::Display};
  case TableKind::Stacked:
    return {0, 0.75, 0.05, 0, Style::Script};
  }
  return {};
}

/// The parts of a row of letters above and below the baseline.
constexpr double strutAscent = 0.7;
constexpr double strutDepth = 0.3;

constexpr double ruleThickness = 0.04;
/// Between the two rules of a double one.
constexpr double doubleRuleGap = 0.16;
/// Between a rule at a table's edge and the entries.
constexpr double edgeRoom = 0.5;

class TableSetter {
public:
  TableSetter(Sheet &sheet, const Table &table, SetStyle style)
      : m_sheet(sheet), m_table(table), m_style(style), m_spacing(spacingOf(table.kind)),
        m_em(sheet.em(style)), m_all(sheet.begin()) {}

  Box set() {
    setCells();
    measureRows();
    measureColumns();
    placeCells();
    putColumnRules();
    putRowRules();
    m_all.width = m_width;
    m_all.ascent = m_top;
    m_all.depth = m_height - m_top;
    m_sheet.close(m_all);
    return m_all;
  }

private:
  struct RowSize {
    double ascent = 0;
    double depth = 0;
  };
  struct ColumnSize {
    double left = 0;
    double width = 0;
  };

  void setCells();
  [[nodiscard]] Box setCell(const Row &cell, std::size_t column);
  void measureRows();
  void measureColumns();
  void placeCells();
  void putColumnRules();
  void putRowRules();
  void putRules(double x, double top, int count, bool isVertical);
  [[nodiscard]] Align alignOf(std::size_t column) const;
  [[nodiscard]] double gapBefore(std::size_t column) const;
  [[nodiscard]] int rulesBefore(std::size_t column) const;
  [[nodiscard]] double roomAtEdge(std::size_t column) const;
  /// In small tables, what is given in em of the text is smaller too.
  [[nodiscard]] double em(double length) const { return length * m_em; }

  Sheet &m_sheet;
  const Table &m_table;
  SetStyle m_style;
  Spacing m_spacing;
  double m_em;
  Box m_all;
  std::vector<std::vector<Box>> m_cells;
  std::vector<RowSize> m_rows;
  std::vector<ColumnSize> m_columns;
  double m_width = 0;
  double m_height = 0;
  double m_top = 0; ///< above the baseline
};

Box TableSetter::setCell(const Row &cell, std::size_t column) {
  const bool isSmaller = m_style.size > m_spacing.cellStyle;
  const SetStyle style = isSmaller ? m_style : m_style.sized(m_spacing.cellStyle);
  // What an aligned relation stands behind is in the column before it.
  RowPlan plan;
  if (m_table.kind == TableKind::Aligned && column % 2 == 1)
    plan.before = AtomClass::Ord;
  Box box = setRow(m_sheet, cell, style, plan);
  box.width = box.fullWidth();
  box.italics = 0;
  return box;
}

void TableSetter::setCells() {
  for (const TableRow &row : m_table.rows) {
    std::vector<Box> &boxes = m_cells.emplace_back();
    for (const Row &cell : row.cells) {
      const std::size_t column = boxes.size();
      boxes.push_back(setCell(cell, column));
      m_columns.resize(std::max(m_columns.size(), column + 1));
      m_columns[column].width = std::max(m_columns[column].width, boxes.back().width);
    }
  }
}

void TableSetter::measureRows() {
  for (std::size_t row = 0; row < m_cells.size(); ++row) {
    RowSize size{em(m_spacing.rowHeight * strutAscent), em(m_spacing.rowHeight * strutDepth)};
    for (const Box &box : m_cells[row]) {
      size.ascent = std::max(size.ascent, box.ascent + em(m_spacing.rowGap) / 2);
      size.depth = std::max(size.depth, box.depth + em(m_spacing.rowGap) / 2);
    }
    size.depth += em(m_table.rows[row].roomBelow);
    m_rows.push_back(size);
    m_height += size.ascent + size.depth;
  }
  m_top = m_sheet.axis(m_style) + m_height / 2;
}

void TableSetter::measureColumns() {
  double x = roomAtEdge(0);
  for (std::size_t column = 0; column < m_columns.size(); ++column) {
    x += column == 0 ? 0 : gapBefore(column);
    m_columns[column].left = x;
    x += m_columns[column].width;
  }
  m_width = x + roomAtEdge(m_columns.size());
}

double TableSetter::gapBefore(std::size_t column) const {
  const bool isInsidePair = m_table.kind == TableKind::Aligned && column % 2 == 1;
  const int further = std::max(0, rulesBefore(column) - 1);
  return isInsidePair ? 0 : em(m_spacing.columnGap + further * doubleRuleGap);
}

int TableSetter::rulesBefore(std::size_t column) const {
  return column < m_table.columnRules.size() ? m_table.columnRules[column] : 0;
}

/// The edge stands off where it has a rule, or rules end there.
double TableSetter::roomAtEdge(std::size_t column) const {
  const bool hasRowRules =
      m_table.rulesBelow > 0 || std::any_of(m_table.rows.begin(), m_table.rows.end(),
                                            [](const TableRow &row) { return row.rulesAbove > 0; });
  const int rules = rulesBefore(column);
  if (rules == 0 && !hasRowRules)
    return em(m_spacing.edge);
  return em(edgeRoom + std::max(0, rules - 1) * doubleRuleGap);
}

Align TableSetter::alignOf(std::size_t column) const {
  if (m_table.columns.empty())
    return Align::Center;
  const std::size_t count = m_table.columns.size();
  return m_table.columns[m_table.kind == TableKind::Aligned ? column % count : std::min(column, count - 1)];
}

void TableSetter::placeCells() {
  double y = m_top;
  for (std::size_t row = 0; row < m_cells.size(); ++row) {
    y -= m_rows[row].ascent;
    for (std::size_t column = 0; column < m_cells[row].size(); ++column) {
      const double spare = m_columns[column].width - m_cells[row][column].width;
      const Align align = alignOf(column);
      const double right = align == Align::Left ? 0 : align == Align::Right ? spare : spare / 2;
      m_sheet.place(m_all, m_cells[row][column], m_columns[column].left + right, y);
    }
    y -= m_rows[row].depth;
  }
}

/// Rules beside (or below) each other, the middle of them all at x (or top).
void TableSetter::putRules(double x, double top, int count, bool isVertical) {
  const double thickness = em(ruleThickness);
  const double step = em(doubleRuleGap);
  const double first = -((count - 1) * step + thickness) / 2;
  for (int i = 0; i < count; ++i) {
    const double offset = first + i * step;
    if (isVertical)
      m_sheet.putRule(x + offset, top, thickness, m_height);
    else
      m_sheet.putRule(x, top - offset, m_width, thickness);
  }
}

void TableSetter::putColumnRules() {
  for (std::size_t column = 0; column <= m_columns.size(); ++column) {
    const int count = rulesBefore(column);
    const double half = (std::max(0, count - 1) * em(doubleRuleGap) + em(ruleThickness)) / 2;
    double x = half;
    if (column == m_columns.size())
      x = m_width - half;
    else if (column > 0)
      x = m_columns[column].left - gapBefore(column) / 2;
    putRules(x, m_top, count, true);
  }
}

void TableSetter::putRowRules() {
  double y = m_top;
  for (std::size_t row = 0; row < m_table.rows.size(); ++row) {
    putRules(0, y, m_table.rows[row].rulesAbove, false);
    y -= m_rows[row].ascent + m_rows[row].depth;
  }
  putRules(0, y, m_table.rulesBelow, false);
}

} // namespace

Box set(Sheet &sheet, const Table &table, SetStyle style) { return TableSetter(sheet, table, style).set(); }

} // namespace halfspace::math
