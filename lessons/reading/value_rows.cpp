#include "lessons/reading/value_rows.h"

#include "lessons/reading/csv_reader.h"
#include "lessons/reading/document.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
/// An object with lists.
constexpr int deepestJson = 2;

Problem tooManyRows(const std::string &file, int line) {
  return {
      words("The file has too many rows: at most {count} are read.", {{"count", std::to_string(mostRows)}}),
      file, line, ""};
}

/// The number of a column, which is added where there is none of this name; nothing where there would be too
/// many.
std::optional<std::size_t> columnFor(const std::string &name, ValueRows &rows) {
  if (const auto column = rows.columnOf(name))
    return column;
  if (rows.columns.size() >= mostColumns)
    return {};
  rows.columns.push_back(name);
  return rows.columns.size() - 1;
}

/// A cell as `--set` takes it: with points, and with commas between numbers.
std::string spelledForSet(std::string cell, char separator) {
  if (separator != ';')
    return cell;
  if (cell.find(';') != std::string::npos)
    return replacedAll(replacedAll(std::move(cell), ",", "."), ";", ",");
  return std::count(cell.begin(), cell.end(), ',') == 1 ? replacedAll(std::move(cell), ",", ".") : cell;
}

std::optional<Problem> readHeader(CsvReader &reader, ValueRows &rows) {
  auto header = reader.next();
  if (!header)
    return header.problem();
  if (!*header)
    return {};
  auto &cells = (*header)->cells;
  while (cells.back().empty()) // the whole row is not
    cells.pop_back();
  for (const std::string &name : cells) {
    if (name.empty())
      return Problem{words("A column has no name: the first row names the coordinates, as --set does."),
                     rows.file, (*header)->line, ""};
    if (rows.columnOf(name))
      return Problem{words("Two columns have this name."), rows.file, (*header)->line, shortened(name)};
    rows.columns.push_back(name);
  }
  return {};
}

/// The values of a row below the names of its columns.
Result<ValueRow> valuesOf(const CsvRow &cells, const ValueRows &rows, char separator) {
  ValueRow row{{}, cells.line};
  for (std::size_t column = 0; column < cells.cells.size(); ++column) {
    const std::string &cell = cells.cells[column];
    if (cell.empty())
      continue;
    if (column >= rows.columns.size())
      return Problem{
          words("“{text}” stands in a column without a name. Numbers with commas between them need "
                "quotes around them.",
                {{"text", shortened(cell)}}),
          rows.file, cells.line, ""};
    row.values.push_back({column, spelledForSet(cell, separator)});
  }
  return row;
}

std::optional<Problem> readCsv(std::string_view text, ValueRows &rows) {
  CsvReader reader(text, rows.file);
  if (auto problem = readHeader(reader, rows))
    return problem;
  while (true) {
    const auto cells = reader.next();
    if (!cells)
      return cells.problem();
    if (!*cells)
      return {};
    if (rows.rows.size() >= mostRows)
      return tooManyRows(rows.file, (*cells)->line);
    auto row = valuesOf(**cells, rows, reader.separator());
    if (!row)
      return row.problem();
    rows.rows.push_back(std::move(*row));
  }
}

/// A value of JSON as `--set` takes it; empty for null, nothing for what is no value of a coordinate.
std::optional<std::string> spelledForSet(const DocumentNode &node) {
  if (node.spellsNumber())
    return std::string(trimmed(node.text));
  if (node.kind == DocumentNode::Kind::Literal && node.text == "null")
    return "";
  if (node.kind != DocumentNode::Kind::List || node.children.empty())
    return {};
  std::string list;
  for (const DocumentNode &number : node.children) {
    if (!number.spellsNumber())
      return {};
    list += (list.empty() ? "" : ",") + number.text;
  }
  return list;
}

Result<ValueRow> valuesOf(const DocumentNode &object, int line, ValueRows &rows) {
  ValueRow row{{}, line};
  for (const DocumentNode &field : object.children) {
    const auto value = spelledForSet(field);
    if (!value || value->size() > maxFieldText)
      return Problem{words("This is no value of a coordinate: write it as 3, \"-10/3\" or [1, 2, 3]."),
                     rows.file, line, shortened(field.key)};
    const auto column = columnFor(field.key, rows);
    if (!column)
      return Problem{words("The file has too many columns: at most {count} are read.",
                           {{"count", std::to_string(mostColumns)}}),
                     rows.file, line, shortened(field.key)};
    if (!value->empty())
      row.values.push_back({*column, *value});
  }
  return row;
}

std::optional<Problem> readJsonLine(std::string_view text, int line, ValueRows &rows) {
  if (rows.rows.size() >= mostRows)
    return tooManyRows(rows.file, line);
  const auto object = parseJson(text, rows.file, deepestJson);
  if (!object || object->kind != DocumentNode::Kind::Map)
    return Problem{words("This line is no JSON object with a value for each name, as {example}.",
                         {{"example", R"({"Q": [11, 15, 8], "t": 0.5})"}}),
                   rows.file, line, ""};
  auto row = valuesOf(*object, line, rows);
  if (!row)
    return row.problem();
  rows.rows.push_back(std::move(*row));
  return {};
}

std::optional<Problem> readJsonLines(std::string_view text, ValueRows &rows) {
  for (int line = 1; !text.empty(); ++line) {
    const auto end = std::min(text.find('\n'), text.size());
    if (const auto json = trimmed(text.substr(0, end)); !json.empty())
      if (auto problem = readJsonLine(json, line, rows))
        return problem;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return {};
}

} // namespace

std::optional<std::size_t> ValueRows::columnOf(std::string_view name) const {
  const auto found = std::find(columns.begin(), columns.end(), name);
  return found == columns.end() ? std::nullopt
                                : std::optional(static_cast<std::size_t>(found - columns.begin()));
}

std::string ValueRows::valueIn(std::size_t row, std::size_t column) const {
  for (const ColumnValue &value : rows[row].values)
    if (value.column == column)
      return value.value;
  return {};
}

Result<ValueRows> readValueRows(std::string_view text, const std::string &file) {
  if (const auto at = firstNoText(text))
    return Problem{notText(), file, lineAt(text, *at), ""};
  if (text.starts_with(byteOrderMark))
    text.remove_prefix(byteOrderMark.size());
  ValueRows rows{file, {}, {}};
  const bool isJson = trimmed(text).starts_with('{');
  if (auto problem = isJson ? readJsonLines(text, rows) : readCsv(text, rows))
    return std::move(*problem);
  if (rows.rows.empty())
    return Problem{
        words("The file has no rows of values: its first row names the coordinates, and each row below "
              "it is for a figure."),
        file, 0, ""};
  return rows;
}

} // namespace halfspace
