// JSON and YAML as one tree, read from a stranger's hands: bounded in depth, without aliases, no key twice,
// every node with its line. Neither library's types nor its exceptions come past this file.
#pragma once

#include "lessons/result.h"

#include <optional>
#include <string_view>
#include <vector>

namespace halfspace {

/// A part of a document. Numbers and truth values are kept as they are spelled.
struct DocumentNode {
  /// In YAML all that is neither a list nor a map is a text; in JSON a number is not, nor are true, false and
  /// null.
  enum class Kind { Text, Number, Literal, List, Map };
  Kind kind = Kind::Text;
  std::string key;  ///< its name in the map above
  std::string text; ///< for Kind::Text, Number and Literal
  std::vector<DocumentNode> children;
  int line = 0; ///< counted from 1

  [[nodiscard]] bool spellsNumber() const { return kind == Kind::Text || kind == Kind::Number; }
  /// The child with this key, or null.
  [[nodiscard]] const DocumentNode *find(std::string_view name) const;
};

/// Reads a JSON text nested at most `maxDepth` deep.
[[nodiscard]] Result<DocumentNode> parseJson(std::string_view text, const std::string &file, int maxDepth);

/// Reads a YAML text nested at most `maxDepth` deep; it begins at `firstLine` of the file.
[[nodiscard]] Result<DocumentNode> parseYaml(std::string_view text, const std::string &file, int firstLine,
                                             int maxDepth);

/// Reads the fields of a node, and keeps the first problem: after one, every reading gives an empty value.
class FieldReader {
public:
  FieldReader(const DocumentNode &node, std::string file, std::string path)
      : m_node(node), m_file(std::move(file)), m_path(std::move(path)) {}

  /// Says that keys other than these are a problem.
  void allowOnly(std::initializer_list<std::string_view> keys);
  [[nodiscard]] const DocumentNode *optional(std::string_view key) const { return m_node.find(key); }
  /// The field, or null and a problem when it is missing.
  [[nodiscard]] const DocumentNode *required(std::string_view key);
  /// A text of at most maxFieldText bytes; `fallback` when it is missing, a problem when there is no
  /// fallback.
  [[nodiscard]] std::string text(std::string_view key,
                                 const std::optional<std::string> &fallback = std::nullopt);
  /// The id of a lesson: small letters, digits and hyphens.
  [[nodiscard]] std::string lessonId(std::string_view key);
  /// A whole number between the bounds.
  [[nodiscard]] int integer(std::string_view key, int lowest, int highest,
                            std::optional<int> fallback = std::nullopt);
  /// Whether the field says true or false; `fallback` when it is missing.
  [[nodiscard]] bool truth(std::string_view key, bool fallback);

  /// The full path of a field: `scene[1].n`.
  [[nodiscard]] std::string pathOf(std::string_view key) const;
  /// Keeps a problem with a field, unless there is one already.
  void complain(const DocumentNode &where, std::string field, std::string sentence);
  void keep(Problem problem);
  [[nodiscard]] const std::optional<Problem> &problem() const { return m_problem; }
  [[nodiscard]] const std::string &file() const { return m_file; }

private:
  const DocumentNode &m_node;
  std::string m_file;
  std::string m_path;
  std::optional<Problem> m_problem;
};

/// The line of a place in a text, counted from 1.
[[nodiscard]] int lineAt(std::string_view text, std::size_t place);

/// The sentence for a file whose bytes are not all text.
[[nodiscard]] std::string notText();

/// The longest text of one field, in bytes.
inline constexpr std::size_t maxFieldText = 4000;

} // namespace halfspace
