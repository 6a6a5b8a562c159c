#include "widgets/formula/read_latex_tables.h"

#include "lessons/words.h"
#include "widgets/formula/latex_arguments.h"
#include "widgets/formula/latex_command_readers.h"
#include "widgets/formula/latex_errors.h"

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

[[noreturn]] void failColumns(std::size_t column) {
  throw ReadError{column, halfspace::words("A table's columns are `l`, `c` and `r`, with `|` for a rule.")};
}

void readColumns(LatexReader &reader, const CommandCall &call, Table &table) {
  if (reader.tokens().peekMath().is('['))
    (void)reader.tokens().takeBetween('[', ']'); // where a table stands: ours stand on the axis
  const std::size_t column = reader.tokens().peekMath().column;
  const std::string columns = readName(reader.tokens(), call.column);
  table.columnRules = {0};
  for (const char letter : columns) {
    if (letter == '|') {
      ++table.columnRules.back();
    } else if (letter == 'l' || letter == 'c' || letter == 'r') {
      table.columns.push_back(letter == 'l' ? Align::Left : letter == 'c' ? Align::Center : Align::Right);
      table.columnRules.push_back(0);
      reader.countNode();
    } else if (letter != ' ') {
      failColumns(column);
    }
  }
  if (table.columns.empty())
    failColumns(column);
}

int readRules(LatexReader &reader) {
  int rules = 0;
  for (; reader.tokens().peekMath().isCommand("hline"); ++rules) {
    reader.countNode();
    (void)reader.tokens().take();
  }
  return rules;
}

bool isAtTableEnd(TokenStream &tokens) {
  const Token &token = tokens.peekMath();
  return token.isEnd() || token.is('}') || token.isCommand("end");
}

void readCells(LatexReader &reader, TableRow &tableRow) {
  do {
    reader.countNode();
    tableRow.cells.push_back(reader.readRow());
  } while (reader.tokens().takeIf('&'));
}

bool takeRowBreak(TokenStream &tokens, TableRow &tableRow) {
  const Token token = tokens.peekMath();
  if (!token.isCommand("\\") && !token.isCommand("cr") && !token.isCommand("tabularnewline"))
    return false;
  (void)tokens.take();
  if (tokens.peek().is('*'))
    (void)tokens.take();
  // Behind a space, a bracket belongs to the next row.
  if (tokens.peek().is('[')) {
    std::string length;
    for (const Token &each : tokens.takeBetween('[', ']'))
      length += sourceOf(each);
    tableRow.roomBelow = lengthOf(length, token.column);
  }
  return true;
}

} // namespace

void readTableRows(LatexReader &reader, Table &table) {
  Surroundings &surroundings = reader.surroundings();
  const Within option(surroundings.inOption, false);
  const Within alphabet(surroundings.alphabet, surroundings.alphabet);
  for (bool isMore = true; isMore;) {
    TableRow tableRow;
    tableRow.rulesAbove = readRules(reader);
    if (isAtTableEnd(reader.tokens())) {
      table.rulesBelow = tableRow.rulesAbove;
      break;
    }
    readCells(reader, tableRow);
    isMore = takeRowBreak(reader.tokens(), tableRow);
    table.rows.push_back(std::move(tableRow));
  }
}

std::string endOf(const std::string &environment) { return "\\end{" + environment + "}"; }

void readEnvironment(LatexReader &reader, Row &row, const CommandCall &call) {
  const Nesting nesting = reader.nested();
  const std::string name = readName(reader.tokens(), call.column);
  const Environment *known = environmentNamed(name);
  const Environment environment = known ? *known : smallFenced(name);
  if (!known && name != "array" && !isInSmallFences(name))
    throw ReadError{call.column, halfspace::words("The environment `{name}` is unknown.", {{"name", name}})};
  Table table;
  table.kind = name == "array" ? TableKind::Matrix : environment.kind;
  if (name == "array")
    readColumns(reader, call, table);
  else
    table.columns.assign(environment.columns.begin(),
                         environment.columns.begin() + static_cast<std::ptrdiff_t>(environment.columnCount));
  readTableRows(reader, table);
  if (!reader.tokens().peekMath().isCommand("end"))
    failUnclosed(reader.tokens(), call.column, "\\begin{" + name + "}", endOf(name));
  const Token closing = reader.tokens().take();
  if (const std::string end = readName(reader.tokens(), closing.column); end != name)
    throw ReadError{closing.column, halfspace::words("`{found}` stands where `{due}` is due.",
                                                     {{"found", endOf(end)}, {"due", endOf(name)}})};
  Node made = math::table(std::move(table));
  const bool isFenced = name != "array" && (environment.open != 0 || environment.close != 0);
  reader.add(row, isFenced ? fenced(environment.open, math::row(std::move(made)), environment.close)
                           : std::move(made));
}

void readSubstack(LatexReader &reader, Row &row, const CommandCall &call) {
  const Nesting nesting = reader.nested();
  if (!reader.tokens().takeIf('{'))
    throw ReadError{call.column, halfspace::words("A `{` is missing behind this command.")};
  Table table;
  table.kind = TableKind::Stacked;
  table.columns = {Align::Center};
  readTableRows(reader, table);
  if (!reader.tokens().takeIf('}'))
    failUnclosed(reader.tokens(), call.column, "{", "}");
  reader.add(row, math::table(std::move(table)));
}

} // namespace halfspace::math
