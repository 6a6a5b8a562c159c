// Words for labels and texts out of Markdown that a test writes.
#pragma once

#include "lessons/lesson/filled_markdown.h"
#include "lessons/reading/markdown_text.h"

#include <QString>

namespace halfspace::test {

/// In which live values stand as they are written.
inline FilledMarkdown asWritten(const QString &markdown) {
  return withNames(MarkdownText(markdown.toStdString()).markdown());
}

} // namespace halfspace::test
