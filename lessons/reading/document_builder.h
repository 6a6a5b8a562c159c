// Builds a DocumentNode from a parser's events.
#pragma once

#include "lessons/reading/document.h"

namespace halfspace {

/// More than this is no session and no lesson, and would only fill the memory.
inline constexpr std::size_t maxDocumentNodes = 100000;
inline constexpr std::size_t maxMapKeys = 200;

/// Takes the events of a JSON or YAML parser in order; every function says whether to go on. After `false`,
/// problem() tells why.
class DocumentBuilder {
public:
  DocumentBuilder(std::string file, int maxDepth) : m_file(std::move(file)), m_maxDepth(maxDepth) {}

  bool key(std::string text, int line);
  /// A Text, a Number or a Literal.
  bool scalar(DocumentNode::Kind kind, std::string text, int line);
  bool open(DocumentNode::Kind kind, int line);
  bool close();

  bool refuse(std::string sentence, int line);
  /// Whether the next text of a map is a key.
  [[nodiscard]] bool expectsKey() const;
  [[nodiscard]] const std::optional<Problem> &problem() const { return m_problem; }
  /// The finished tree; a problem when there was one, or when nothing was read.
  [[nodiscard]] Result<DocumentNode> finish();

private:
  bool count(int line);
  bool add(DocumentNode node);

  std::string m_file;
  int m_maxDepth;
  std::size_t m_nodes = 0;
  std::vector<DocumentNode> m_open;
  std::optional<std::string> m_key;
  std::optional<DocumentNode> m_root;
  std::optional<Problem> m_problem;
};

} // namespace halfspace
