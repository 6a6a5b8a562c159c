#include "lessons/reading/document_builder.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <nlohmann/json.hpp>

namespace halfspace {
namespace {

using Json = nlohmann::json;
using Kind = DocumentNode::Kind;

/// The library's number for "number overflow".
constexpr int numberOverflow = 406;

/// Counts the lines of a text up to places that only move forward.
class LineCounter {
public:
  explicit LineCounter(std::string_view text) : m_text(text) {}
  int lineAt(std::size_t position) {
    for (; m_counted < position && m_counted < m_text.size(); ++m_counted)
      m_line += m_text[m_counted] == '\n' ? 1 : 0;
    return m_line;
  }

private:
  std::string_view m_text;
  std::size_t m_counted = 0;
  int m_line = 1;
};

/// Lets the parser read a text and tells how far it has come.
class WatchedIterator {
public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char *;
  using reference = const char &;

  WatchedIterator(const char *at, std::size_t *taken) : m_at(at), m_taken(taken) {}
  reference operator*() const { return *m_at; }
  WatchedIterator &operator++() {
    ++m_at;
    ++*m_taken;
    return *this;
  }
  bool operator==(const WatchedIterator &other) const { return m_at == other.m_at; }
  bool operator!=(const WatchedIterator &other) const { return m_at != other.m_at; }

private:
  const char *m_at;
  std::size_t *m_taken;
};

/// The receiver of nlohmann's events.
class JsonEvents : public nlohmann::json_sax<Json> {
public:
  JsonEvents(DocumentBuilder &builder, std::string_view text, const std::size_t &taken)
      : m_builder(builder), m_lines(text), m_taken(taken) {}

  bool null() override { return m_builder.scalar(Kind::Literal, "null", line()); }
  bool boolean(bool value) override {
    return m_builder.scalar(Kind::Literal, value ? "true" : "false", line());
  }
  bool number_integer(number_integer_t value) override {
    return m_builder.scalar(Kind::Number, std::to_string(value), line());
  }
  bool number_unsigned(number_unsigned_t value) override {
    return m_builder.scalar(Kind::Number, std::to_string(value), line());
  }
  bool number_float(number_float_t, const string_t &spelled) override {
    return m_builder.scalar(Kind::Number, spelled, line());
  }
  bool string(string_t &value) override { return m_builder.scalar(Kind::Text, value, line()); }
  bool binary(binary_t &) override { return false; } // not in JSON texts
  bool start_object(std::size_t) override { return m_builder.open(Kind::Map, line()); }
  bool key(string_t &value) override { return m_builder.key(value, line()); }
  bool end_object() override { return m_builder.close(); }
  bool start_array(std::size_t) override { return m_builder.open(Kind::List, line()); }
  bool end_array() override { return m_builder.close(); }
  bool parse_error(std::size_t, const std::string &, const Json::exception &exception) override {
    if (exception.id == numberOverflow)
      return m_builder.refuse(words("This number is too large to be read."), line());
    return m_builder.refuse(words("The file is damaged here: it is not the JSON text that this program "
                                  "writes. Perhaps it is cut off."),
                            line());
  }

private:
  // The parser is one character ahead after a number.
  int line() { return m_lines.lineAt(m_taken == 0 ? 0 : m_taken - 1); }

  DocumentBuilder &m_builder;
  LineCounter m_lines;
  const std::size_t &m_taken;
};

} // namespace

Result<DocumentNode> parseJson(std::string_view text, const std::string &file, int maxDepth) {
  // The library takes a zero byte for the end of the text.
  if (const auto at = firstNoText(text))
    return Problem{notText(), file, lineAt(text, *at), ""};
  DocumentBuilder builder(file, maxDepth);
  std::size_t taken = 0;
  JsonEvents events(builder, text, taken);
  const bool read = Json::sax_parse(WatchedIterator(text.data(), &taken),
                                    WatchedIterator(text.data() + text.size(), &taken), &events);
  if (!read)
    builder.refuse(words("The file is damaged: it is not the JSON text that this program writes."), 0);
  return builder.finish();
}

} // namespace halfspace
