#include "lessons/reading/document_builder.h"

#include "lessons/text.h"
#include "lessons/words.h"

namespace halfspace {

bool DocumentBuilder::key(std::string text, int line) {
  if (m_open.back().children.size() >= maxMapKeys)
    return refuse(words("There are too many fields here: at most {limit} are read.",
                        {{"limit", std::to_string(maxMapKeys)}}),
                  line);
  if (m_open.back().find(text))
    return refuse(words("“{key}” stands here twice. Keep one of them.", {{"key", shortened(text)}}), line);
  m_key = std::move(text);
  return true;
}

bool DocumentBuilder::scalar(DocumentNode::Kind kind, std::string text, int line) {
  if (!count(line))
    return false;
  DocumentNode node;
  node.kind = kind;
  node.text = std::move(text);
  node.line = line;
  return add(std::move(node));
}

bool DocumentBuilder::open(DocumentNode::Kind kind, int line) {
  if (static_cast<int>(m_open.size()) >= m_maxDepth)
    return refuse(words("Lists and maps are nested too deeply: at most {limit} levels are read.",
                        {{"limit", std::to_string(m_maxDepth)}}),
                  line);
  if (!count(line))
    return false;
  DocumentNode node;
  node.kind = kind;
  node.line = line;
  node.key = std::exchange(m_key, std::nullopt).value_or("");
  m_open.push_back(std::move(node));
  return true;
}

bool DocumentBuilder::close() {
  DocumentNode node = std::move(m_open.back());
  m_open.pop_back();
  m_key = node.key;
  return add(std::move(node));
}

bool DocumentBuilder::refuse(std::string sentence, int line) {
  if (!m_problem)
    m_problem = Problem{std::move(sentence), m_file, line, ""};
  return false;
}

bool DocumentBuilder::expectsKey() const {
  return !m_open.empty() && m_open.back().kind == DocumentNode::Kind::Map && !m_key;
}

Result<DocumentNode> DocumentBuilder::finish() {
  if (m_problem)
    return *m_problem;
  if (!m_root)
    return Problem{words("There is nothing to read here."), m_file, 0, ""};
  return std::move(*m_root);
}

bool DocumentBuilder::count(int line) {
  return ++m_nodes <= maxDocumentNodes ||
         refuse(words("The file holds too much: at most {limit} values are read.",
                      {{"limit", std::to_string(maxDocumentNodes)}}),
                line);
}

bool DocumentBuilder::add(DocumentNode node) {
  node.key = std::exchange(m_key, std::nullopt).value_or("");
  if (m_open.empty())
    m_root = std::move(node);
  else
    m_open.back().children.push_back(std::move(node));
  return true;
}

} // namespace halfspace
