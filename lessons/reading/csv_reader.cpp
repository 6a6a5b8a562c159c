#include "lessons/reading/csv_reader.h"

#include "lessons/reading/document.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <utility>

namespace halfspace {
namespace {

constexpr char quote = '"';

bool endsLine(char c) { return c == '\n' || c == '\r'; }

/// What parts the cells of a text, by its first row.
char separatorOf(std::string_view text) {
  bool isQuoted = false;
  bool hasTab = false;
  for (const char c : text) {
    if (c == quote)
      isQuoted = !isQuoted;
    if (isQuoted)
      continue;
    if (endsLine(c))
      break;
    if (c == ';')
      return c;
    hasTab = hasTab || c == '\t';
  }
  return hasTab ? '\t' : ',';
}

} // namespace

CsvReader::CsvReader(std::string_view text, std::string file)
    : m_rest(text), m_file(std::move(file)), m_separator(separatorOf(text)) {}

Result<std::optional<CsvRow>> CsvReader::next() {
  while (!m_rest.empty()) {
    auto read = row();
    if (!read)
      return read.problem();
    const auto isEmpty = [](const std::string &cell) { return cell.empty(); };
    if (!std::all_of(read->cells.begin(), read->cells.end(), isEmpty))
      return std::optional(std::move(*read));
  }
  return std::optional<CsvRow>();
}

Result<CsvRow> CsvReader::row() {
  CsvRow row{{}, m_line};
  while (true) {
    auto read = cell();
    if (!read)
      return read.problem();
    row.cells.push_back(std::move(*read));
    if (row.cells.size() > mostCsvCells)
      return problemAt(m_line, words("This row has too many cells: at most {count} are read.",
                                     {{"count", std::to_string(mostCsvCells)}}));
    if (!isAt(m_separator))
      break;
    m_rest.remove_prefix(1);
  }
  takeLineEnd();
  return row;
}

Result<std::string> CsvReader::cell() {
  skipBlanks();
  Result<std::string> text = isAt(quote) ? quotedCell() : plainCell();
  if (text && text->size() > maxFieldText)
    return problemAt(m_line, words("This cell is too long: at most {count} bytes are read.",
                                   {{"count", std::to_string(maxFieldText)}}));
  return text;
}

Result<std::string> CsvReader::quotedCell() {
  const int firstLine = m_line;
  m_rest.remove_prefix(1);
  std::string text;
  while (!m_rest.empty()) {
    if (isAt(quote)) {
      m_rest.remove_prefix(1);
      if (!isAt(quote)) {
        skipBlanks();
        if (!isAtCellEnd())
          return problemAt(m_line,
                           words("Behind the quotes of a cell something follows that is no part of it: "
                                 "a quote within a cell is written twice."));
        return std::string(trimmed(text));
      }
    }
    if (takeLineEnd()) {
      text += '\n';
      continue;
    }
    text += m_rest.front();
    m_rest.remove_prefix(1);
  }
  return problemAt(firstLine, words("The quotes that begin a cell here do not end."));
}

std::string CsvReader::plainCell() {
  const auto end =
      std::find_if(m_rest.begin(), m_rest.end(), [this](char c) { return c == m_separator || endsLine(c); });
  const auto length = static_cast<std::size_t>(end - m_rest.begin());
  std::string text(trimmed(m_rest.substr(0, length)));
  m_rest.remove_prefix(length);
  return text;
}

bool CsvReader::takeLineEnd() {
  if (m_rest.empty() || !endsLine(m_rest.front()))
    return false;
  m_rest.remove_prefix(m_rest.starts_with("\r\n") ? 2 : 1);
  ++m_line;
  return true;
}

void CsvReader::skipBlanks() {
  while (!m_rest.empty() && m_rest.front() != m_separator && (isAt(' ') || isAt('\t')))
    m_rest.remove_prefix(1);
}

bool CsvReader::isAtCellEnd() const {
  return m_rest.empty() || m_rest.front() == m_separator || endsLine(m_rest.front());
}

} // namespace halfspace
