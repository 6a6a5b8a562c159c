#include "lessons/reading/yaml_hint.h"

#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace halfspace {
namespace {

struct Bracket {
  char sign;
  int line;
};

char closingOf(char opening) { return opening == '[' ? ']' : '}'; }

/// Finds brackets without a partner, outside quotes and comments.
class BracketScanner {
public:
  explicit BracketScanner(std::string_view text) : m_text(text) {}

  /// The innermost that is open where another sort closes, one that closes nothing, or the first that is open
  /// at the end.
  [[nodiscard]] std::optional<Bracket> findLone() {
    for (m_at = 0; m_at < m_text.size(); ++m_at)
      if (const auto lone = look(m_text[m_at]))
        return lone;
    return m_open.empty() ? std::nullopt : std::optional(m_open.front());
  }

private:
  std::optional<Bracket> look(char character) {
    if (character == '\n')
      ++m_line;
    else if (character == '#' && isBehindSpace())
      passTo('\n');
    else if ((character == '\'' || character == '"') && beginsValue())
      passTo(character);
    else if ((character == '[' || character == '{') && (!m_open.empty() || beginsValue()))
      m_open.push_back({character, m_line});
    else if (character == ']' || character == '}')
      return close(character);
    return {};
  }

  std::optional<Bracket> close(char character) {
    if (m_open.empty())
      return closesMore() ? std::optional(Bracket{character, m_line}) : std::nullopt;
    const auto closesIt = [&](const Bracket &each) { return closingOf(each.sign) == character; };
    const Bracket innermost = m_open.back();
    if (!closesIt(innermost))
      return std::ranges::any_of(m_open, closesIt) ? innermost : Bracket{character, m_line};
    m_open.pop_back();
    return {};
  }

  /// To the place of the character, or to just before the end of the line.
  void passTo(char character) {
    for (++m_at; m_at < m_text.size() && m_text[m_at] != character; ++m_at)
      if (m_text[m_at] == '\n')
        ++m_line;
    if (character == '\n')
      --m_at;
  }

  [[nodiscard]] bool isBehindSpace() const {
    return m_at == 0 || std::string_view(" \t\n").find(m_text[m_at - 1]) != std::string_view::npos;
  }

  /// The last character before this place that is no space; null at the beginning of a line.
  [[nodiscard]] char before() const {
    const auto place = m_text.substr(0, m_at).find_last_not_of(' ');
    return place == std::string_view::npos || m_text[place] == '\n' ? '\0' : m_text[place];
  }

  [[nodiscard]] bool beginsValue() const {
    const char sign = before();
    const std::string_view signs = m_open.empty() ? ":-" : ":-,[{"; // a plain text has commas, too
    return sign == '\0' || signs.find(sign) != std::string_view::npos;
  }

  [[nodiscard]] bool closesMore() const { return before() == ']' || before() == '}'; }

  std::string_view m_text;
  std::size_t m_at = 0;
  int m_line = 1;
  std::vector<Bracket> m_open;
};

std::string_view lineIn(std::string_view text, int line) {
  for (; line > 1; --line)
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

/// `title: Roof: how far` with its value in quotes; empty where this is no such line.
std::string withQuotes(std::string_view line) {
  constexpr std::string_view colon = ": ";
  const auto end = line.find(colon);
  if (end == std::string_view::npos)
    return {};
  const std::string_view value = trimmed(line.substr(end));
  const std::string_view text = trimmed(value.substr(1));
  const bool isPlain = line.find_first_of("[{") > end && text.find(colon) != std::string_view::npos &&
                       std::string_view("'\"[{").find(text.front()) == std::string_view::npos;
  return isPlain ? std::string(trimmed(line.substr(0, end))) + ": '" +
                       replacedAll(std::string(text), "'", "''") + "'"
                 : std::string();
}

YamlHint colonHint(std::string_view text, int line) {
  const std::string quoted = withQuotes(lineIn(text, line));
  return {quoted.empty()
              ? words("Perhaps a text with a colon in it needs quotes, or the line above lacks its colon.")
              : words("A text with a colon in it needs quotes. Perhaps “{line}” is meant.",
                      {{"line", shortened(quoted)}}),
          line};
}

YamlHint bracketHint(const Bracket &lone) {
  const bool opens = lone.sign == '[' || lone.sign == '{';
  return {opens ? words("Perhaps a {closing} is missing: this {opening} is never closed.",
                        {{"opening", std::string(1, lone.sign)},
                         {"closing", std::string(1, closingOf(lone.sign))}})
                : words("Perhaps there is a {closing} too many.", {{"closing", std::string(1, lone.sign)}}),
          lone.line};
}

} // namespace

std::string singleQuotesHint() {
  return words("In double quotes a backslash begins a sign of YAML's own: put the text in single quotes.");
}

YamlHint yamlHint(std::string_view text, std::string_view reason, int line) {
  if (const auto lone = BracketScanner(text).findLone())
    return bracketHint(*lone);
  const auto speaksOf = [&](std::string_view what) { return reason.find(what) != std::string_view::npos; };
  if (speaksOf("map value"))
    return colonHint(text, line);
  if (speaksOf("escape") || speaksOf("hex number")) // the latter of \xi, \underline and \Upsilon
    return {singleQuotesHint(), line};
  if (speaksOf("flow"))
    return {words("Perhaps a comma is missing, or the space behind a colon."), line};
  const std::string_view wrong = lineIn(text, line);
  if (wrong.starts_with('\t'))
    return {words("Perhaps spaces are meant: this line is indented by a tab."), line};
  // Newer libraries speak of a scalar.
  if ((speaksOf("end of") || speaksOf("scalar")) && wrong.find_first_of("'\"") != std::string_view::npos)
    return {words("Perhaps a text in quotes has such a quote in it: write that twice."), line};
  if (speaksOf("end of"))
    return {words("Perhaps this line is indented too much or too little."), line};
  return {"", line};
}

} // namespace halfspace
