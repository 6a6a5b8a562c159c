// Words in Markdown with what they were read as.
#pragma once

#include "lessons/reading/markdown.h"

#include <memory>

namespace halfspace {

/// A text in Markdown. It is read when it is made, and by nobody after that: whoever checks it or shows it
/// looks at what was read. A value, whose copies share that.
class MarkdownText {
public:
  /// No words.
  MarkdownText();
  /// Reads a text in UTF-8. Words that stand in code are such texts as they stand there.
  MarkdownText(std::string written); // NOLINT(google-explicit-constructor)
  MarkdownText(const char *written)
      : MarkdownText(std::string(written)) {} // NOLINT(google-explicit-constructor)

  [[nodiscard]] const std::string &written() const { return m_content->written; }
  [[nodiscard]] bool isEmpty() const { return written().empty(); }
  /// Of a text that cannot be read one paragraph, in which it stands as it is written.
  [[nodiscard]] const Markdown &markdown() const { return m_content->markdown; }
  bool operator==(const MarkdownText &other) const { return written() == other.written(); }
  /// Why it cannot be read, see readMarkdown; nothing where it can.
  [[nodiscard]] const std::optional<Problem> &problem() const { return m_content->problem; }

private:
  struct Content {
    std::string written;
    Markdown markdown;
    std::optional<Problem> problem;
  };
  [[nodiscard]] static Content read(std::string written);

  std::shared_ptr<const Content> m_content;
};

} // namespace halfspace
