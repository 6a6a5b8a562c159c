#include "lessons/reading/markdown_text.h"

#include <sstream>
#include <utility>

namespace halfspace {
namespace {

/// The words of a text on one line, with single spaces between them.
std::string onOneLine(const std::string &text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;)
    line += (line.empty() ? "" : " ") + word;
  return line;
}

Markdown asWritten(const std::string &text) {
  MarkdownBlock paragraph;
  paragraph.spans.push_back({MarkdownSpan::Kind::Text, onOneLine(text)});
  return {{paragraph}, {}};
}

} // namespace

MarkdownText::Content MarkdownText::read(std::string written) {
  auto read = readMarkdown(written);
  if (read)
    return {std::move(written), std::move(*read), {}};
  Markdown paragraph = asWritten(written);
  return {std::move(written), std::move(paragraph), read.problem()};
}

MarkdownText::MarkdownText() {
  static const auto none = std::make_shared<const Content>();
  m_content = none;
}

MarkdownText::MarkdownText(std::string written)
    : m_content(std::make_shared<const Content>(read(std::move(written)))) {}

} // namespace halfspace
