#include "widgets/handout/set_table.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

/// Between columns, and above and below the words of a row, in ems.
constexpr double columnGap = 1.4;
constexpr double rowGap = 0.18;
/// The rules above and below the table, and below its head, in ems.
constexpr double outerRule = 0.07;
constexpr double innerRule = 0.045;

/// How wide the lines of a cell are where they need not be broken.
double naturalWidth(const TableCell &cell, ParagraphPlan plan, const HandoutFonts &fonts) {
  ReadingOrder unread; // it is only measured
  plan.ends = LineEnds::Ragged;
  double width = 0;
  for (const SetLine &line : setParagraph(cell.text, plan, fonts, unread))
    width = std::max(width, line.width);
  return width;
}

std::vector<double> naturalWidths(const TableBlock &table, const ParagraphPlan &plan,
                                  const HandoutFonts &fonts) {
  std::vector<double> widths;
  for (const TableRow &row : table.rows) {
    widths.resize(std::max(widths.size(), row.cells.size()));
    for (std::size_t i = 0; i < row.cells.size(); ++i)
      widths[i] = std::max(widths[i], naturalWidth(row.cells[i], plan, fonts));
  }
  return widths;
}

/// Narrow columns keep their width; those that are wider than an equal share have what is left, equally.
std::vector<double> fittedWidths(std::vector<double> widths, double room) {
  std::vector<std::size_t> byWidth(widths.size());
  for (std::size_t i = 0; i < byWidth.size(); ++i)
    byWidth[i] = i;
  std::sort(byWidth.begin(), byWidth.end(),
            [&](std::size_t a, std::size_t b) { return widths[a] < widths[b]; });
  for (std::size_t i = 0; i < byWidth.size(); ++i) {
    const double share = room / static_cast<double>(byWidth.size() - i);
    double &width = widths[byWidth[i]];
    width = std::min(width, share);
    room -= width;
  }
  return widths;
}

class TableSetter {
public:
  TableSetter(const TableBlock &table, const ParagraphPlan &plan, const HandoutFonts &fonts,
              ReadingOrder &order)
      : m_table(table), m_plan(plan), m_fonts(fonts), m_order(order), m_widths(widthsOf()) {}

  std::vector<Chunk> set() {
    const std::size_t element = m_order.add("Table", m_plan.element);
    std::vector<Chunk> rows;
    for (const TableRow &row : m_table.rows)
      rows.push_back(set(row, element));
    if (rows.empty())
      return rows;
    addRule(0, outerRule, rows.front());
    addRule(rows.back().height, outerRule, rows.back());
    return rows;
  }

private:
  [[nodiscard]] std::vector<double> widthsOf() const {
    std::vector<double> widths = naturalWidths(m_table, m_plan, m_fonts);
    const double gaps = gap() * static_cast<double>(std::max<std::size_t>(widths.size(), 1) - 1);
    return fittedWidths(std::move(widths), std::max(m_plan.width - gaps, m_plan.size));
  }

  [[nodiscard]] double gap() const { return columnGap * m_plan.size; }
  [[nodiscard]] double tableWidth() const {
    double width = -gap();
    for (const double column : m_widths)
      width += column + gap();
    return std::max(width, 0.0);
  }

  Chunk set(const TableRow &row, std::size_t table) {
    const std::size_t element = m_order.add("TR", table);
    Chunk chunk;
    double left = 0;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      setCell(row.cells[i], row.isHeading, element, {left, m_widths[i]}, chunk);
      left += m_widths[i] + gap();
    }
    chunk.height += 2 * rowGap * m_plan.size;
    chunk.keepsWithNext = row.isHeading;
    if (row.isHeading)
      addRule(chunk.height, innerRule, chunk);
    return chunk;
  }

  struct CellRoom {
    double left;
    double width;
  };

  void setCell(const TableCell &cell, bool isHeading, std::size_t row, const CellRoom &room, Chunk &chunk) {
    ParagraphPlan plan = m_plan;
    plan.width = room.width + rounding;
    plan.ends = LineEnds::Ragged;
    plan.element = isHeading ? m_order.add("TH", row, "/A<</O/Table/Scope/Column>>") : m_order.add("TD", row);
    double y = rowGap * m_plan.size;
    for (SetLine &line : setParagraph(cell.text, plan, m_fonts, m_order)) {
      const double slack = std::max(room.width - line.width, 0.0);
      const double inset = cell.side == TableCell::Side::Right    ? slack
                           : cell.side == TableCell::Side::Middle ? slack / 2
                                                                  : 0;
      for (SetThing &thing : line.things)
        chunk.things.push_back(moved(std::move(thing), {room.left + inset, y + line.ascent}));
      y += line.ascent + line.depth;
    }
    chunk.height = std::max(chunk.height, y - rowGap * m_plan.size);
  }

  void addRule(double y, double ems, Chunk &chunk) const {
    const double thickness = ems * m_plan.size;
    chunk.things.push_back({RulePart{{0, y - thickness / 2, tableWidth(), thickness}, {}}, {}, 0});
  }

  /// A line as wide as its cell fits into it, whatever sums were rounded.
  static constexpr double rounding = 1e-6;

  const TableBlock &m_table;
  const ParagraphPlan &m_plan;
  const HandoutFonts &m_fonts;
  ReadingOrder &m_order;
  std::vector<double> m_widths;
};

} // namespace

std::vector<Chunk> setTable(const TableBlock &table, const ParagraphPlan &plan, const HandoutFonts &fonts,
                            ReadingOrder &order) {
  return TableSetter(table, plan, fonts, order).set();
}

} // namespace halfspace
