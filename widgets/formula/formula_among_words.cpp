#include "widgets/formula/formula_among_words.h"

#include "widgets/formula/read_latex.h"
#include "widgets/formula/term_formula.h"

#include <algorithm>
#include <iterator>

namespace halfspace {
namespace {

using math::AtomClass;
using math::Row;

/// What stands before a formula in a line, and behind it: punctuation has no space before it, even behind
/// \right).
Row inLine(Row formula, const std::string &punctuation) {
  Row row = math::row(math::styleSwitch(math::Style::Text), std::move(formula));
  if (!punctuation.empty())
    row.push_back({math::Group{{math::words(punctuation)}}, AtomClass::Close});
  return row;
}

/// A formula or a side of one; nothing where it cannot be read.
std::optional<Row> read(const std::string &latex, const Macros &macros) {
  auto row = math::readLatex(latex, macros);
  return std::holds_alternative<Row>(row) ? std::optional(std::get<Row>(std::move(row))) : std::nullopt;
}

bool isLatex(const FormulaSide &side) { return std::holds_alternative<std::string>(side); }

std::optional<Row> rowOf(const FilledFormula &formula, const Macros &macros) {
  Row row;
  for (const FormulaSide &side : formula.sides) {
    if (!row.empty() && !formula.relation.empty())
      row.push_back(math::symbol(static_cast<unsigned char>(formula.relation.front()), AtomClass::Rel));
    auto next = isLatex(side) ? read(std::get<std::string>(side), macros)
                              : std::optional(formulaOf(std::get<LiveNumber>(side)));
    if (!next)
      return {};
    std::move(next->begin(), next->end(), std::back_inserter(row));
  }
  return row;
}

} // namespace

std::optional<Row> rowAmongWords(const FilledFormula &formula, const Macros &macros) {
  auto row = std::all_of(formula.sides.begin(), formula.sides.end(), isLatex) ? read(latexOf(formula), macros)
                                                                              : rowOf(formula, macros);
  if (row && !formula.large)
    row = inLine(std::move(*row), formula.punctuation);
  return row;
}

} // namespace halfspace
