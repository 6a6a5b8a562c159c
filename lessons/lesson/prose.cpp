#include "lessons/lesson/prose.h"

#include "lessons/term/greek.h"
#include "lessons/text.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace halfspace {
namespace {

/// Braces nested deeper than this are not ours.
constexpr int maxNesting = 64;

struct Replacement {
  std::string_view from;
  std::string_view to;
};

/// Commands that stand for a character, or for nothing. Formulas that are set in type have a table of many
/// more (`symbolCommands` in widgets/formula), and other facts in it: the class of a symbol, from which its
/// gaps follow, and signs that only a mathematical font has (⋅ and ⟂ for · and ⊥, ∘ for what is ° in a line
/// of text). Here a sign comes with the gaps that it has in a line of text, and a command that is not in the
/// table stays the word that it is, which reads well enough.
constexpr std::array commands{Replacement{"cdot", "·"},       Replacement{"times", "×"},
                              Replacement{"perp", "⊥"},       Replacement{"circ", "°"},
                              Replacement{"approx", " ≈ "},   Replacement{"leq", " ≤ "},
                              Replacement{"le", " ≤ "},       Replacement{"geq", " ≥ "},
                              Replacement{"ge", " ≥ "},       Replacement{"neq", " ≠ "},
                              Replacement{"ne", " ≠ "},       Replacement{"pm", " ± "},
                              Replacement{"lvert", "|"},      Replacement{"rvert", "|"},
                              Replacement{"lVert", "‖"},      Replacement{"rVert", "‖"},
                              Replacement{"cos", "cos "},     Replacement{"sin", "sin "},
                              Replacement{"colon", ":"},      Replacement{"prime", "′"},
                              Replacement{"ldots", "…"},      Replacement{"Rightarrow", " ⇒ "},
                              Replacement{"to", " → "},       Replacement{"in", " ∈ "},
                              Replacement{"quad", " "},       Replacement{"qquad", " "},
                              Replacement{",", " "},          Replacement{";", " "},
                              Replacement{":", " "},          Replacement{" ", " "},
                              Replacement{"\\", " "},         Replacement{"!", ""},
                              Replacement{"|", "‖"},          Replacement{"{", "{"},
                              Replacement{"}", "}"},          Replacement{"%", "%"},
                              Replacement{"left", ""},        Replacement{"right", ""},
                              Replacement{"bigl", ""},        Replacement{"bigr", ""},
                              Replacement{"Bigl", ""},        Replacement{"Bigr", ""},
                              Replacement{"displaystyle", ""}};

constexpr std::array superscripts{Replacement{"0", "⁰"}, Replacement{"1", "¹"}, Replacement{"2", "²"},
                                  Replacement{"3", "³"}, Replacement{"4", "⁴"}, Replacement{"5", "⁵"},
                                  Replacement{"6", "⁶"}, Replacement{"7", "⁷"}, Replacement{"8", "⁸"},
                                  Replacement{"9", "⁹"}, Replacement{"−", "⁻"}, Replacement{"⊥", "⊥"},
                                  Replacement{"°", "°"}, Replacement{"′", "′"}};

constexpr std::array subscripts{Replacement{"0", "₀"}, Replacement{"1", "₁"}, Replacement{"2", "₂"},
                                Replacement{"3", "₃"}, Replacement{"4", "₄"}, Replacement{"5", "₅"},
                                Replacement{"6", "₆"}, Replacement{"7", "₇"}, Replacement{"8", "₈"},
                                Replacement{"9", "₉"}, Replacement{"x", "ₓ"}};

template <std::size_t size>
const Replacement *find(const std::array<Replacement, size> &table, std::string_view from) {
  const auto found =
      std::find_if(table.begin(), table.end(), [from](const Replacement &each) { return each.from == from; });
  return found == table.end() ? nullptr : &*found;
}

/// Each character raised or lowered; nothing when one has no such form.
template <std::size_t size>
std::string inSmall(const std::array<Replacement, size> &table, std::string_view text) {
  std::string small;
  while (!text.empty()) {
    const std::size_t length = lengthOfFirst(text);
    const Replacement *replacement = find(table, text.substr(0, length));
    if (!replacement)
      return {};
    small += replacement->to;
    text.remove_prefix(length);
  }
  return small;
}

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// Whether the text is one pair of parentheses with nothing behind it, as the arguments in `f(Q)`.
bool isOneGroup(std::string_view text) {
  return text.size() > 2 && text.front() == '(' && text.find(')') == text.size() - 1;
}

/// Whether a text may stand beside a slash or under a root without parentheses: a number, a name, f(Q), |n|.
bool standsAlone(std::string_view text) {
  if (text.size() > 2 && text.front() == '|' && text.find('|', 1) == text.size() - 1)
    return true;
  const auto open = text.find('(');
  if (open != std::string_view::npos && isOneGroup(text.substr(open)))
    text = text.substr(0, open);
  constexpr std::array<std::string_view, 6> breaks{" ", "·", "×", "/", "(", "√"};
  return std::none_of(breaks.begin(), breaks.end(),
                      [text](std::string_view each) { return contains(text, each); });
}

std::string parenthesized(const std::string &text) { return standsAlone(text) ? text : "(" + text + ")"; }

/// Reads LaTeX from the left and writes plain text.
class Converter {
public:
  explicit Converter(std::string_view latex, int nesting = 0) : m_rest(latex), m_nesting(nesting) {}

  std::string convert() {
    while (!m_rest.empty())
      step();
    return m_text;
  }

private:
  void step() {
    const char c = m_rest.front();
    if (c == '\\')
      return command();
    if (c == '{') {
      m_text += converted(argument());
      return;
    }
    const std::size_t length = lengthOfFirst(m_rest);
    const std::string_view character = m_rest.substr(0, length);
    m_rest.remove_prefix(length);
    if (c == '_' || c == '^')
      script(c);
    else
      symbol(character);
  }

  void symbol(std::string_view character) {
    switch (character.front()) {
    case ' ':
    case '~':
    case '&':
    case '}':
      return;
    case '=':
    case '<':
    case '>':
      m_text += " " + std::string(character) + " ";
      return;
    case '+':
      m_text += " + ";
      return;
    case '-':
      m_text += signFollows() ? "−" : " − ";
      return;
    case ',':
      m_text += ", ";
      return;
    case '\'':
      m_text += "′";
      return;
    default:
      m_text += character;
    }
  }

  /// Whether a minus here belongs to the number behind it rather than between two terms.
  [[nodiscard]] bool signFollows() const {
    constexpr std::array<std::string_view, 12> before{"(", "=", "<", ">", "≈", "≤",
                                                      "≥", "≠", "+", "·", "×", ","};
    const auto end = m_text.find_last_not_of(' ');
    const std::string_view text = std::string_view(m_text).substr(0, end == std::string::npos ? 0 : end + 1);
    return text.empty() || std::any_of(before.begin(), before.end(),
                                       [text](std::string_view each) { return text.ends_with(each); });
  }

  void script(char kind) {
    const std::string content = converted(argument());
    const std::string small = kind == '_' ? inSmall(subscripts, content) : inSmall(superscripts, content);
    m_text += !small.empty() ? small : kind + parenthesized(content);
  }

  void command() {
    m_rest.remove_prefix(1);
    const std::string_view name = takeCommandName();
    if (name == "frac" || name == "tfrac" || name == "dfrac")
      return fraction();
    if (name == "sqrt") {
      m_text += "√" + parenthesized(converted(argument()));
    } else if (name == "mark") {
      argument();
      m_text += converted(argument());
    } else if (name == "text" || name == "mathrm" || name == "operatorname") {
      m_text += argument();
    } else if (name == "hat") {
      constexpr std::string_view combiningCircumflex = "\u0302";
      m_text += converted(argument()).append(combiningCircumflex);
    } else if (const Replacement *replacement = find(commands, name)) {
      m_text += replacement->to;
    } else if (const GreekLetter *greek = greekCommand(name)) {
      m_text += greek->letter;
    } else if (name != "vec" && name != "mathbf") {
      m_text += name;
    }
  }

  /// a/b; in parentheses where a factor follows, because 1/3x would be read as 1/(3x).
  void fraction() {
    const std::string top = parenthesized(converted(argument()));
    std::string bottom = parenthesized(converted(argument()));
    if (bottom.starts_with("−"))
      bottom = "(" + bottom + ")";
    const std::string quotient = top + "/" + bottom;
    m_text += factorFollows() ? "(" + quotient + ")" : quotient;
  }

  /// Whether what comes next is multiplied with what stands here, without a sign between them.
  [[nodiscard]] bool factorFollows() const {
    std::string_view rest = m_rest;
    while (rest.starts_with(' ') || rest.starts_with("\\,"))
      rest.remove_prefix(rest.front() == ' ' ? 1 : 2);
    if (rest.empty())
      return false;
    if (rest.front() != '\\')
      return isLetter(rest.front()) || (rest.front() >= '0' && rest.front() <= '9') || rest.front() == '(' ||
             rest.front() == '{';
    constexpr std::array<std::string_view, 8> factors{"\\vec",  "\\sqrt",  "\\left", "\\bigl",
                                                      "\\mark", "\\lvert", "\\frac", "\\tfrac"};
    // `\left` also begins `\leftarrow`, which this program does not write.
    return std::any_of(factors.begin(), factors.end(),
                       [rest](std::string_view each) { return rest.starts_with(each); });
  }

  std::string_view takeCommandName() {
    std::size_t length = 0;
    while (length < m_rest.size() && isLetter(m_rest[length]))
      ++length;
    length = std::min(std::max<std::size_t>(length, 1), m_rest.size());
    const std::string_view name = m_rest.substr(0, length);
    m_rest.remove_prefix(length);
    return name;
  }

  /// The next group without its braces, command with its name, or character.
  std::string_view argument() {
    m_rest.remove_prefix(std::min(m_rest.find_first_not_of(' '), m_rest.size()));
    if (m_rest.empty())
      return {};
    std::size_t length = lengthOfFirst(m_rest);
    if (m_rest.front() == '\\')
      while (length < m_rest.size() && isLetter(m_rest[length]))
        ++length;
    if (m_rest.front() != '{') {
      const std::string_view one = m_rest.substr(0, length);
      m_rest.remove_prefix(length);
      return one;
    }
    int depth = 0;
    for (length = 0; length < m_rest.size(); ++length) {
      depth += m_rest[length] == '{' ? 1 : m_rest[length] == '}' ? -1 : 0;
      if (depth == 0)
        break;
    }
    const std::string_view group = m_rest.substr(1, length - 1);
    m_rest.remove_prefix(std::min(length + 1, m_rest.size()));
    return group;
  }

  [[nodiscard]] std::string converted(std::string_view latex) const {
    return m_nesting < maxNesting ? Converter(latex, m_nesting + 1).convert() : std::string(latex);
  }

  std::string_view m_rest;
  int m_nesting;
  std::string m_text;
};

/// Runs of spaces as one, none at the ends or inside parentheses' ends.
std::string tidied(const std::string &text) {
  std::string tidy;
  for (const char c : text) {
    const bool afterOpening = tidy.empty() || tidy.back() == ' ' || tidy.back() == '(';
    if (c == ' ' && afterOpening)
      continue;
    if ((c == ')' || c == ',') && !tidy.empty() && tidy.back() == ' ')
      tidy.pop_back();
    tidy += c;
  }
  if (!tidy.empty() && tidy.back() == ' ')
    tidy.pop_back();
  return tidy;
}

} // namespace

std::string plainProse(const std::string &latex, const Macros &macros) {
  const std::string known = expanded(latex, macros);
  return tidied(Converter(known).convert());
}

} // namespace halfspace
