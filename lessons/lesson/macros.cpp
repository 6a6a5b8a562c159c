#include "lessons/lesson/macros.h"

#include "lessons/lesson/macro_work.h"
#include "lessons/text.h"

#include <algorithm>
#include <set>
#include <vector>

namespace halfspace {
namespace {

/// Where the first `#` stands; \# is a sign of its own. At the end where there is none.
std::size_t firstParameter(std::string_view body) {
  std::size_t at = 0;
  while (at < body.size() && body[at] != '#')
    at += body[at] == '\\' ? std::size_t{2} : std::size_t{1};
  return std::min(at, body.size());
}

/// The name of the command whose backslash stands here: letters or one other character.
std::string_view commandAt(std::string_view text, std::size_t backslash) {
  std::size_t end = backslash + 1;
  while (end < text.size() && isLetter(text[end]))
    ++end;
  end = std::min(std::max(end, backslash + 2), text.size());
  return text.substr(backslash + 1, end - backslash - 1);
}

/// Whether a letter behind the text would become part of its last command.
bool endsInCommand(std::string_view text) {
  constexpr std::size_t longestCommand = 64;
  std::size_t letters = 0;
  while (letters < std::min(text.size(), longestCommand) && isLetter(text[text.size() - 1 - letters]))
    ++letters;
  return letters > 0 && letters < text.size() && text[text.size() - 1 - letters] == '\\';
}

/// Keeps a command and what was not written behind it apart.
void join(std::string &text, std::string_view more) {
  if (!more.empty() && isLetter(more.front()) && endsInCommand(text))
    text += ' ';
  text += more;
}

/// The macros that a body names.
std::vector<std::string_view> usedIn(std::string_view body, const Macros &macros) {
  std::vector<std::string_view> used;
  for (auto at = body.find('\\'); at != std::string_view::npos && at + 1 < body.size();
       at = body.find('\\', at)) {
    const std::string_view name = commandAt(body, at);
    if (macros.contains(name))
      used.push_back(name);
    at += 1 + name.size();
  }
  return used;
}

/// Follows what macros use, and remembers those that come to an end.
class RecursionFinder {
public:
  explicit RecursionFinder(const Macros &macros) : m_macros(macros) {}

  /// The first one that is come upon again; empty where all comes to an end.
  std::string_view findFrom(std::string_view name) {
    if (m_harmless.contains(name))
      return {};
    if (!m_around.insert(name).second)
      return name;
    std::string_view found;
    for (const std::string_view used : usedIn(m_macros.find(name)->second.body, m_macros))
      if (found.empty())
        found = findFrom(used);
    m_around.erase(name);
    if (found.empty())
      m_harmless.insert(name);
    return found;
  }

private:
  const Macros &m_macros;
  std::set<std::string_view> m_around;
  std::set<std::string_view> m_harmless;
};

/// Replaces macros from left to right; what they bring is read again.
class Expander {
public:
  Expander(std::string_view latex, const Macros &macros)
      : m_macros(macros), m_upcoming(latex.rbegin(), latex.rend()) {}

  /// Nothing where it becomes too long.
  std::optional<std::string> expand() {
    while (!m_upcoming.empty() && m_brought <= longestExpansion)
      step();
    return m_brought <= longestExpansion ? std::optional(std::move(m_text)) : std::nullopt;
  }
  [[nodiscard]] std::size_t brought() const { return m_brought; }

private:
  void step() {
    const std::string taken = takeOne();
    const auto macro = taken.front() == '\\' ? m_macros.find(taken.substr(1)) : m_macros.end();
    if (macro == m_macros.end()) {
      m_text += taken;
      return;
    }
    std::vector<std::string> arguments(static_cast<std::size_t>(macro->second.arguments));
    for (std::string &argument : arguments)
      argument = takeArgument();
    bring(macro->second.body, arguments);
  }

  void bring(std::string_view body, const std::vector<std::string> &arguments) {
    std::string filled;
    while (!body.empty() && filled.size() <= longestExpansion) {
      const std::size_t written = firstParameter(body);
      join(filled, body.substr(0, written));
      body.remove_prefix(written);
      if (body.empty())
        break;
      join(filled, arguments.at(parameterAt(body, 0) - 1));
      body.remove_prefix(2);
    }
    if (endsInCommand(filled))
      filled += ' ';
    if (!filled.empty() && isLetter(filled.front()) && endsInCommand(m_text))
      m_text += ' ';
    m_brought += filled.size() + 1; // an empty body counts too, so that the work of many is bounded
    m_upcoming.append(filled.rbegin(), filled.rend());
  }

  /// A command with its backslash, or a byte.
  std::string takeOne() {
    std::string one(1, takeByte());
    if (one.front() != '\\' || m_upcoming.empty())
      return one;
    one += takeByte();
    while (isLetter(one[1]) && !m_upcoming.empty() && isLetter(m_upcoming.back()))
      one += takeByte();
    return one;
  }

  char takeByte() {
    const char byte = m_upcoming.back();
    m_upcoming.pop_back();
    return byte;
  }

  /// The next group with its braces, command or character; empty at the end.
  std::string takeArgument() {
    while (!m_upcoming.empty() && m_upcoming.back() == ' ')
      m_upcoming.pop_back();
    if (m_upcoming.empty())
      return {};
    std::string argument = takeOne();
    for (int depth = argument == "{" ? 1 : 0; depth > 0 && !m_upcoming.empty();) {
      const std::string one = takeOne();
      depth += one == "{" ? 1 : one == "}" ? -1 : 0;
      argument += one;
    }
    while (argument.front() != '{' && !m_upcoming.empty() && continuesCharacter(m_upcoming.back()))
      argument += takeByte();
    return argument;
  }

  const Macros &m_macros;
  std::string m_upcoming; ///< the next byte is the last
  std::string m_text;
  std::size_t m_brought = 0;
};

} // namespace

std::size_t parameterAt(std::string_view body, std::size_t at) {
  const bool isOne = body[at] == '#' && at + 1 < body.size() && body[at + 1] >= '1' && body[at + 1] <= '9';
  return isOne ? static_cast<std::size_t>(body[at + 1] - '0') : 0;
}

std::optional<Macro> macroOf(std::string body) {
  Macro macro;
  std::string_view rest = body;
  for (rest.remove_prefix(firstParameter(rest)); !rest.empty(); rest.remove_prefix(firstParameter(rest))) {
    const auto parameter = static_cast<int>(parameterAt(rest, 0));
    if (parameter == 0)
      return {};
    macro.arguments = std::max(macro.arguments, parameter);
    rest.remove_prefix(2);
  }
  macro.body = std::move(body);
  return macro;
}

std::optional<std::string> findRecursion(const Macros &macros) {
  RecursionFinder finder(macros);
  for (const auto &[name, macro] : macros)
    if (const std::string_view found = finder.findFrom(name); !found.empty())
      return std::string(found);
  return {};
}

std::string expanded(const std::string &latex, const Macros &macros) {
  if (macros.empty())
    return latex;
  return Expander(latex, macros).expand().value_or(latex);
}

std::size_t bytesFromMacros(const std::string &latex, const Macros &macros) {
  if (macros.empty())
    return 0;
  Expander expander(latex, macros);
  static_cast<void>(expander.expand());
  return expander.brought();
}

} // namespace halfspace
