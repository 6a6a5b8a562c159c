#include "widgets/formula/nesting.h"

#include <algorithm>
#include <array>
#include <utility>

namespace halfspace::math {
namespace {

struct Environment {
  std::string_view name;
  TableKind kind = TableKind::Matrix;
  std::array<Align, 2> columns{Align::Center, Align::Center};
  std::size_t columnCount = 1; ///< how many of these it has
  char32_t open = 0;
  char32_t close = 0;
};

constexpr std::array<Align, 2> centered{Align::Center, Align::Center};
constexpr std::array<Align, 2> leftSided{Align::Left, Align::Left};
constexpr std::array<Align, 2> paired{Align::Right, Align::Left};

/// `array`, whose columns are given, is read apart.
constexpr std::array<Environment, 21> environments{{
    {"matrix"},
    {"pmatrix", TableKind::Matrix, centered, 1, '(', ')'},
    {"bmatrix", TableKind::Matrix, centered, 1, '[', ']'},
    {"Bmatrix", TableKind::Matrix, centered, 1, '{', '}'},
    {"vmatrix", TableKind::Matrix, centered, 1, '|', '|'},
    {"Vmatrix", TableKind::Matrix, centered, 1, U'‖', U'‖'},
    {"smallmatrix", TableKind::SmallMatrix},
    {"cases", TableKind::Cases, leftSided, 1, '{', 0},
    {"dcases", TableKind::Cases, leftSided, 1, '{', 0},
    {"rcases", TableKind::Cases, leftSided, 1, 0, '}'},
    {"align", TableKind::Aligned, paired, 2},
    {"align*", TableKind::Aligned, paired, 2},
    {"aligned", TableKind::Aligned, paired, 2},
    {"split", TableKind::Aligned, paired, 2},
    {"eqnarray*", TableKind::Aligned, paired, 2},
    {"gather", TableKind::Gathered},
    {"gather*", TableKind::Gathered},
    {"gathered", TableKind::Gathered},
    {"multline*", TableKind::Gathered},
    {"equation", TableKind::Gathered},
    {"equation*", TableKind::Gathered},
}};

/// A small matrix between parentheses is small as well.
bool isInSmallFences(std::string_view name) { return name == "psmallmatrix" || name == "bsmallmatrix"; }

Environment smallFenced(std::string_view name) {
  Environment environment{name, TableKind::SmallMatrix};
  environment.open = name.starts_with('p') ? '(' : '[';
  environment.close = name.starts_with('p') ? ')' : ']';
  return environment;
}

const Environment *environmentNamed(std::string_view name) {
  const auto found = std::find_if(environments.begin(), environments.end(),
                                  [name](const Environment &each) { return each.name == name; });
  return found == environments.end() ? nullptr : &*found;
}

} // namespace

void LatexReader::readEnvironment(Row &row, const Command & /*command*/) {
  const Nesting nesting(*this);
  const std::size_t column = m_column;
  const std::string name = readName();
  const Environment *known = environmentNamed(name);
  const Environment environment = known ? *known : smallFenced(name);
  if (!known && name != "array" && !isInSmallFences(name))
    throw ReadError{column, "The environment `" + name + "` is unknown."};
  Table table;
  table.kind = name == "array" ? TableKind::Matrix : environment.kind;
  if (name == "array")
    readColumns(table);
  else
    table.columns.assign(environment.columns.begin(),
                         environment.columns.begin() + static_cast<std::ptrdiff_t>(environment.columnCount));
  readTableRows(table);
  if (!m_tokens.peekMath().isCommand("end"))
    failUnclosed(column, "\\begin{" + name + "}", "\\end{" + name + "}");
  m_column = m_tokens.take().column;
  if (const std::string end = readName(); end != name)
    throw ReadError{m_column, "`\\end{" + end + "}` stands where `\\end{" + name + "}` is due."};
  Node made = math::table(std::move(table));
  const bool isFenced = name != "array" && (environment.open != 0 || environment.close != 0);
  add(row,
      isFenced ? fenced(environment.open, math::row(std::move(made)), environment.close) : std::move(made));
}

void LatexReader::readSubstack(Row &row, const Command & /*command*/) {
  const Nesting nesting(*this);
  const std::size_t column = m_column;
  if (!m_tokens.takeIf('{'))
    throw ReadError{column, "A `{` is missing behind this command."};
  Table table;
  table.kind = TableKind::Stacked;
  table.columns = {Align::Center};
  readTableRows(table);
  if (!m_tokens.takeIf('}'))
    failUnclosed(column, "{", "}");
  add(row, math::table(std::move(table)));
}

void LatexReader::readColumns(Table &table) {
  if (m_tokens.peekMath().is('['))
    (void)m_tokens.takeBetween('[', ']'); // where a table stands: ours stand on the axis
  const std::size_t column = m_tokens.peekMath().column;
  const std::string columns = readName();
  table.columnRules = {0};
  for (const char letter : columns) {
    if (letter == '|') {
      ++table.columnRules.back();
    } else if (letter == 'l' || letter == 'c' || letter == 'r') {
      table.columns.push_back(letter == 'l' ? Align::Left : letter == 'c' ? Align::Center : Align::Right);
      table.columnRules.push_back(0);
      countNode();
    } else if (letter != ' ') {
      throw ReadError{column, "A table's columns are `l`, `c` and `r`, with `|` for a rule."};
    }
  }
  if (table.columns.empty())
    throw ReadError{column, "A table's columns are `l`, `c` and `r`, with `|` for a rule."};
}

int LatexReader::readRules() {
  int rules = 0;
  for (; m_tokens.peekMath().isCommand("hline"); ++rules) {
    countNode();
    (void)m_tokens.take();
  }
  return rules;
}

bool LatexReader::atTableEnd() {
  const Token &token = m_tokens.peekMath();
  return token.isEnd() || token.is('}') || token.isCommand("end");
}

void LatexReader::readTableRows(Table &table) {
  const bool inOption = std::exchange(m_inOption, false);
  const auto alphabet = m_alphabet;
  for (bool isMore = true; isMore;) {
    TableRow tableRow;
    tableRow.rulesAbove = readRules();
    if (atTableEnd()) {
      table.rulesBelow = tableRow.rulesAbove;
      break;
    }
    readCells(tableRow);
    isMore = takeRowBreak(tableRow);
    table.rows.push_back(std::move(tableRow));
  }
  m_alphabet = alphabet;
  m_inOption = inOption;
}

void LatexReader::readCells(TableRow &tableRow) {
  do {
    countNode();
    tableRow.cells.push_back(readRow());
  } while (m_tokens.takeIf('&'));
}

bool LatexReader::takeRowBreak(TableRow &tableRow) {
  const Token token = m_tokens.peekMath();
  if (!token.isCommand("\\") && !token.isCommand("cr") && !token.isCommand("tabularnewline"))
    return false;
  (void)m_tokens.take();
  if (m_tokens.peek().is('*'))
    (void)m_tokens.take();
  // Behind a space, a bracket belongs to the next row.
  if (m_tokens.peek().is('[')) {
    std::string length;
    for (const Token &each : m_tokens.takeBetween('[', ']'))
      length += sourceOf(each);
    tableRow.roomBelow = lengthOf(length, token.column);
  }
  return true;
}

} // namespace halfspace::math
