#include "widgets/formula/read_latex.h"

#include "lessons/words.h"
#include "widgets/formula/latex_errors.h"
#include "widgets/formula/latex_reader.h"
#include "widgets/formula/read_latex_tables.h"

#include <algorithm>
#include <utility>

namespace halfspace::math {
namespace {

/// All of the source.
Row readFormula(LatexReader &reader) {
  Table table;
  table.kind = TableKind::Aligned;
  table.columns = {Align::Right, Align::Left};
  readTableRows(reader, table);
  if (const Token &rest = reader.tokens().peekMath(); !rest.isEnd())
    failStray(rest);
  if (table.rows.empty())
    return {};
  if (table.rows.size() == 1 && table.rows.front().cells.size() == 1)
    return std::move(table.rows.front().cells.front());
  if (std::all_of(table.rows.begin(), table.rows.end(),
                  [](const TableRow &row) { return row.cells.size() == 1; })) {
    table.kind = TableKind::Gathered;
    table.columns = {Align::Center};
  }
  return row(math::table(std::move(table)));
}

} // namespace

std::variant<Row, ReadError> readLatex(std::string_view latex, const Macros &macros) {
  if (latex.size() > longestLatex)
    return ReadError{1, halfspace::words("This formula is too long.")};
  try {
    LatexReader reader(latex, macros);
    return readFormula(reader);
  } catch (ReadError &error) {
    return std::move(error);
  }
}

} // namespace halfspace::math
