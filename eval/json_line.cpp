#include "eval/json_line.h"

#include "eval/json_strings.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

bool isDigit(char c) { return '0' <= c && c <= '9'; }

} // namespace

/// Reads one line by recursive descent; the depth is bounded.
class JsonParser {
public:
  JsonParser(std::string_view text, std::vector<JsonLine::Node> &nodes, const JsonLine &line)
      : m_text(text), m_nodes(nodes), m_line(line) {}

  std::optional<JsonFault> parse() {
    skipSpace();
    if (peek() != '{')
      fail("the line is not a JSON object");
    else if (value(1)) {
      skipSpace();
      if (m_at != m_text.size())
        fail("more text after the object");
    }
    return m_fault;
  }

private:
  [[nodiscard]] char peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }

  bool fail(const char *words) {
    if (!m_fault)
      m_fault = JsonFault{words, m_at + 1};
    return false;
  }

  bool take(char c) {
    if (peek() != c)
      return false;
    ++m_at;
    return true;
  }

  void skipSpace() {
    while (peek() == ' ' || peek() == '\t' || peek() == '\r' || peek() == '\n')
      ++m_at;
  }

  std::size_t open(JsonKind kind) {
    m_nodes.push_back({static_cast<std::uint32_t>(m_at), 0, 0, kind, false});
    return m_nodes.size() - 1;
  }

  bool close(std::size_t node) {
    m_nodes[node].length = static_cast<std::uint32_t>(m_at) - m_nodes[node].begin;
    m_nodes[node].next = static_cast<std::uint32_t>(m_nodes.size());
    return true;
  }

  bool value(int depth) {
    switch (peek()) {
    case '{':
      return depth <= maxJsonDepth ? object(depth) : fail("nested too deep");
    case '[':
      return depth <= maxJsonDepth ? list(depth) : fail("nested too deep");
    case '"':
      return string();
    case 'n':
      return word("null", JsonKind::Null);
    case 't':
      return word("true", JsonKind::True);
    case 'f':
      return word("false", JsonKind::False);
    default:
      return number();
    }
  }

  bool word(std::string_view word, JsonKind kind) {
    if (m_text.substr(m_at, word.size()) != word)
      return fail("not a JSON value");
    const std::size_t node = open(kind);
    m_at += word.size();
    return close(node);
  }

  bool digits() {
    if (!isDigit(peek()))
      return fail("a digit is wanted");
    while (isDigit(peek()))
      ++m_at;
    return true;
  }

  bool number() {
    if (!isDigit(peek()) && peek() != '-')
      return fail("not a JSON value");
    const std::size_t node = open(JsonKind::Number);
    take('-');
    if (!take('0') && !digits()) // no digit follows a leading zero
      return false;
    if (take('.') && !digits())
      return false;
    if (take('e') || take('E')) {
      if (!take('+'))
        take('-');
      if (!digits())
        return false;
    }
    return close(node);
  }

  bool string() {
    const std::size_t node = open(JsonKind::String);
    ++m_at;
    for (;;) {
      if (m_at == m_text.size())
        return fail("a string without end");
      const auto byte = static_cast<unsigned char>(m_text[m_at]);
      if (byte == '"')
        break;
      if (byte < 0x20)
        return fail("a control character in a string");
      if (byte == '\\') {
        m_nodes[node].escaped = true;
        if (!escape())
          return false;
      } else if (byte < 0x80) {
        ++m_at;
      } else if (const std::size_t length = utf8Length(m_text.substr(m_at))) {
        m_at += length;
      } else {
        return fail("invalid UTF-8");
      }
    }
    ++m_at;
    return close(node);
  }

  bool escape() {
    const std::string_view rest = m_text.substr(m_at);
    if (rest.size() > 1 && simpleEscape(rest[1]) != 0) {
      m_at += 2;
      return true;
    }
    const int code = rest.substr(0, 2) == "\\u" ? hexWord(rest.substr(2)) : -1;
    if (code < 0)
      return fail("not an escape sequence");
    if (isHighSurrogate(code)) {
      const std::string_view second = rest.substr(6);
      if (second.substr(0, 2) != "\\u" || !isLowSurrogate(hexWord(second.substr(2))))
        return fail("half a surrogate pair");
      m_at += 6;
    } else if (isLowSurrogate(code)) {
      return fail("half a surrogate pair");
    }
    m_at += 6;
    return true;
  }

  bool list(int depth) {
    const std::size_t node = open(JsonKind::List);
    ++m_at;
    skipSpace();
    if (!take(']')) {
      do {
        skipSpace();
        if (!value(depth + 1))
          return false;
        skipSpace();
      } while (take(','));
      if (!take(']'))
        return fail("a comma or ] is wanted");
    }
    return close(node);
  }

  bool object(int depth) {
    const std::size_t node = open(JsonKind::Map);
    ++m_at;
    skipSpace();
    if (!take('}')) {
      do {
        skipSpace();
        if (peek() != '"')
          return fail("a key is wanted");
        if (!string())
          return false;
        skipSpace();
        if (!take(':'))
          return fail("a colon is wanted");
        skipSpace();
        if (!value(depth + 1))
          return false;
        skipSpace();
      } while (take(','));
      if (!take('}'))
        return fail("a comma or } is wanted");
    }
    close(node);
    return hasDistinctKeys(node) || fail("a key twice in this object");
  }

  /// Few keys are compared pairwise, many are sorted.
  bool hasDistinctKeys(std::size_t object) {
    constexpr std::size_t few = 8;
    std::array<const JsonLine::Node *, few> first{};
    std::size_t count = 0;
    for (std::size_t key = object + 1; key < m_nodes[object].next; key = m_nodes[key + 1].next) {
      if (count == few)
        return hasDistinctKeysAmongMany(object);
      const JsonLine::Node &added = m_nodes[key];
      for (std::size_t i = 0; i < count; ++i)
        if (added.escaped || first[i]->escaped ? m_line.textOf(added) == m_line.textOf(*first[i])
                                               : m_line.spelling(added) == m_line.spelling(*first[i]))
          return false;
      first[count++] = &added;
    }
    return true;
  }

  bool hasDistinctKeysAmongMany(std::size_t object) {
    std::vector<std::string> keys;
    for (std::size_t key = object + 1; key < m_nodes[object].next; key = m_nodes[key + 1].next)
      keys.push_back(m_line.textOf(m_nodes[key]));
    std::sort(keys.begin(), keys.end());
    return std::adjacent_find(keys.begin(), keys.end()) == keys.end();
  }

  std::string_view m_text;
  std::vector<JsonLine::Node> &m_nodes;
  const JsonLine &m_line;
  std::size_t m_at = 0;
  std::optional<JsonFault> m_fault;
};

std::optional<JsonFault> JsonLine::read(std::string_view line) {
  m_text = line;
  m_nodes.clear();
  return JsonParser(line, m_nodes, *this).parse();
}

std::string JsonLine::textOf(const Node &node) const {
  const std::string_view inside = spelling(node).substr(1, node.length - 2);
  return node.escaped ? unescaped(inside) : std::string(inside);
}

bool JsonLine::isText(const Node &node, std::string_view text) const {
  return node.escaped ? textOf(node) == text : spelling(node).substr(1, node.length - 2) == text;
}

JsonKind JsonValue::kind() const { return m_line->m_nodes[m_node].kind; }

std::string_view JsonValue::spelling() const { return m_line->spelling(m_line->m_nodes[m_node]); }

std::string JsonValue::text() const { return m_line->textOf(m_line->m_nodes[m_node]); }

template <class Visit> void JsonValue::visitChildren(Visit visit) const {
  const auto &nodes = m_line->m_nodes;
  const bool keyed = nodes[m_node].kind == JsonKind::Map;
  for (std::uint32_t node = m_node + 1; node < nodes[m_node].next;) {
    const std::uint32_t value = keyed ? node + 1 : node;
    visit(nodes[node], JsonValue(*m_line, value));
    node = nodes[value].next;
  }
}

std::vector<JsonValue> JsonValue::elements() const {
  std::vector<JsonValue> elements;
  visitChildren([&](const auto &, JsonValue value) { elements.push_back(value); });
  return elements;
}

std::optional<JsonValue> JsonValue::find(std::string_view key) const {
  std::optional<JsonValue> found;
  if (kind() == JsonKind::Map)
    visitChildren([&](const auto &node, JsonValue value) {
      if (m_line->isText(node, key))
        found = value;
    });
  return found;
}

bool JsonValue::hasExactly(std::initializer_list<std::string_view> keys) const {
  if (kind() != JsonKind::Map)
    return false;
  std::size_t count = 0;
  bool known = true;
  visitChildren([&](const auto &node, JsonValue) {
    ++count;
    known = known && std::any_of(keys.begin(), keys.end(),
                                 [&](std::string_view key) { return m_line->isText(node, key); });
  });
  return known && count == keys.size();
}

} // namespace halfspace
