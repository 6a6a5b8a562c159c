#include "lessons/lesson/lesson_markup.h"

#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

/// What is indented further is code in Markdown.
constexpr std::size_t deepestIndent = 3;

/// The line without its indent; empty where that is one of code.
std::string_view withoutIndent(std::string_view line) {
  const auto indent = std::min(line.find_first_not_of(' '), line.size());
  return indent > deepestIndent ? std::string_view() : line.substr(indent);
}

/// How many of one character a text begins with.
std::size_t runOf(char character, std::string_view text) {
  return std::min(text.find_first_not_of(character), text.size());
}

} // namespace

bool LineScanner::next() {
  if (m_rest.empty())
    return false;
  const auto end = m_rest.find('\n');
  m_line = m_rest.substr(0, end);
  m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
  if (!m_line.empty() && m_line.back() == '\r')
    m_line.remove_suffix(1);
  ++m_number;
  return true;
}

std::string_view fenceOf(std::string_view line) {
  constexpr std::size_t shortest = 3;
  line = withoutIndent(line);
  if (!line.starts_with('`') && !line.starts_with('~'))
    return {};
  const std::string_view run = line.substr(0, runOf(line.front(), line));
  return run.size() >= shortest ? run : std::string_view();
}

std::string_view wordOfFence(std::string_view line) {
  return trimmed(withoutIndent(line).substr(fenceOf(line).size()));
}

bool closes(std::string_view line, std::string_view opening) {
  const std::string_view fence = fenceOf(line);
  return fence.size() >= opening.size() && fence.front() == opening.front() && wordOfFence(line).empty();
}

std::optional<std::string> stepTitle(std::string_view line) {
  constexpr std::string_view heading = "## ";
  if (!line.starts_with(heading))
    return {};
  return printable(trimmed(line.substr(heading.size())));
}

std::string whyNoStep(std::string_view line) {
  const std::string_view heading = withoutIndent(line);
  const std::size_t marks = runOf('#', heading);
  const std::string_view behind = heading.substr(marks);
  const std::string_view title = trimmed(behind);
  if (title.empty())
    return {};
  const bool isHeading = marks == 2 || (marks == 1 && (title != behind || isLetter(title.front())));
  return isHeading ? words("This heading begins no step. Perhaps “## {title}” is meant.",
                           {{"title", shortened(title)}})
                   : std::string();
}

} // namespace halfspace
