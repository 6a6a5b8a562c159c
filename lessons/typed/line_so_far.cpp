#include "lessons/typed/line_so_far.h"

#include "lessons/text.h"

#include <algorithm>

namespace halfspace {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isOfWord(char c) { return isLetter(c) || isDigit(c) || c == '_' || c == '-' || c == '.'; }

/// Where the word begins that ends at a byte; the byte itself where it ends none.
std::size_t beginOfWord(std::string_view line, std::size_t end) {
  std::size_t begin = end;
  while (begin > 0 && isOfWord(line[begin - 1]))
    --begin;
  while (begin < end && !isLetter(line[begin])) // 2k is a product
    ++begin;
  return begin;
}

std::size_t behindSpaces(std::string_view line, std::size_t at) {
  while (at < line.size() && line[at] == ' ')
    ++at;
  return at;
}

bool separates(std::string_view line, std::size_t at, char decimalMark) {
  if (line[at] != ',')
    return line[at] == ';';
  const bool isBetweenDigits =
      at > 0 && at + 1 < line.size() && isDigit(line[at - 1]) && isDigit(line[at + 1]);
  return decimalMark != ',' || !isBetweenDigits;
}

/// A bracket that is open.
struct OpenCall {
  std::string_view word;
  std::size_t argumentsAt;
  std::vector<std::size_t> separators{};
};

/// The brackets that are open in front of the word at the cursor, the innermost last.
std::vector<OpenCall> openCalls(std::string_view line, const LineSoFar &so, char decimalMark) {
  std::vector<OpenCall> open;
  for (std::size_t at = *so.contentAt; at < so.wordAt; ++at)
    if (line[at] == '(') {
      const std::size_t begin = std::max(beginOfWord(line, at), *so.contentAt);
      open.push_back({line.substr(begin, at - begin), at + 1});
    } else if (open.empty()) {
      continue;
    } else if (line[at] == ')') {
      open.pop_back();
    } else if (separates(line, at, decimalMark)) {
      open.back().separators.push_back(at);
    }
  return open;
}

} // namespace

LineSoFar lineSoFar(std::string_view line, std::size_t cursor, char decimalMark) {
  line = line.substr(0, cursor);
  LineSoFar so;
  so.cursor = line.size();
  so.wordAt = beginOfWord(line, line.size());
  const std::size_t nameAt = behindSpaces(line, 0);
  std::size_t nameEnd = nameAt;
  while (nameEnd < line.size() && isOfWord(line[nameEnd]))
    ++nameEnd;
  so.name = line.substr(nameAt, nameEnd - nameAt);
  const std::size_t signAt = behindSpaces(line, nameEnd);
  if (signAt == line.size() || (line[signAt] != '=' && line[signAt] != ':'))
    return so;
  so.contentAt = behindSpaces(line, signAt + 1);
  const std::vector<OpenCall> open = openCalls(line, so, decimalMark);
  if (open.empty())
    return so;
  so.called = open.back().word;
  so.argumentsAt = open.back().argumentsAt;
  std::size_t begin = so.argumentsAt;
  for (const std::size_t end : open.back().separators) {
    so.arguments.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return so;
}

} // namespace halfspace
