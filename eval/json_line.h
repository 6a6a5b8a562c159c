// One line of JSON, read strictly and with its spelling kept.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfspace {

/// How deep lists and objects may be nested, the outermost counted as 1.
inline constexpr int maxJsonDepth = 64;
/// The longest line that is read, in bytes.
inline constexpr std::size_t maxLineLength = std::size_t{64} << 20U;

enum class JsonKind : std::uint8_t { Null, False, True, Number, String, List, Map };

/// Why a text is not JSON: a few words for a person, and the place, counted in bytes from 1.
struct JsonFault {
  std::string words;
  std::size_t place = 0;
};

class JsonLine;

/// A value in a line. It refers to the line and must not outlive it.
class JsonValue {
public:
  JsonValue(const JsonLine &line, std::uint32_t node) : m_line(&line), m_node(node) {}

  [[nodiscard]] JsonKind kind() const;
  /// As it stands in the line, quotes and all.
  [[nodiscard]] std::string_view spelling() const;
  /// The characters that a string stands for.
  [[nodiscard]] std::string text() const;

  /// The values in a list, or in an object without their keys.
  [[nodiscard]] std::vector<JsonValue> elements() const;
  /// The value with this key; nothing where there is none, or this is no object.
  [[nodiscard]] std::optional<JsonValue> find(std::string_view key) const;
  /// Whether this is an object with these keys and no others.
  [[nodiscard]] bool hasExactly(std::initializer_list<std::string_view> keys) const;

private:
  template <class Visit> void visitChildren(Visit visit) const;

  const JsonLine *m_line;
  std::uint32_t m_node;
};

/// Reads lines of JSON (RFC 8259) one after the other, and keeps the last one as a tree.
///
/// Stricter than the standard asks: the whole is an object, a key stands once in an object, strings are valid
/// UTF-8 without half a surrogate pair, nesting is bounded. Numbers are checked for their form and otherwise
/// left as they are spelled, however large. No library in Debian 12 does both: they turn numbers into
/// doubles, or refuse 1e400.
class JsonLine {
public:
  /// Reads a line of at most `maxLineLength` bytes, which must stay where it is for as long as the values are
  /// used. What was read before is forgotten. Nothing when all is well.
  [[nodiscard]] std::optional<JsonFault> read(std::string_view line);

  /// The object that the line is, once it is read without fault.
  [[nodiscard]] JsonValue root() const { return {*this, 0}; }

private:
  friend class JsonValue;
  friend class JsonParser;

  /// In the order of the text; a key stands before its value.
  struct Node {
    std::uint32_t begin;
    std::uint32_t length;
    std::uint32_t next; ///< the node behind this one and all that it holds
    JsonKind kind;
    bool escaped; ///< whether a string has a backslash
  };
  [[nodiscard]] std::string_view spelling(const Node &node) const {
    return m_text.substr(node.begin, node.length);
  }
  [[nodiscard]] bool isText(const Node &node, std::string_view text) const;
  [[nodiscard]] std::string textOf(const Node &node) const;

  std::string_view m_text;
  std::vector<Node> m_nodes;
};

} // namespace halfspace
