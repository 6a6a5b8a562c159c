#include "lessons/reading/markdown_formulas.h"

#include "lessons/reading/value_name.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

// Formulas are characters of plane 15, which is for private use: in UTF-8 they are the byte F3 and three
// more. That plane has far more of them than `maxMarkdownBytes` have room for formulas.
constexpr char planeByte = '\xF3';
constexpr unsigned firstPlaneByte2 = 0xB0;
constexpr std::size_t standInSize = 4;
constexpr unsigned continuation = 0x80;

/// Braces further apart than this hold no name.
constexpr std::size_t longestName = 80;

std::string standInFor(std::size_t formula) {
  const auto sixBits = [&](unsigned shift) { return static_cast<unsigned>(formula >> shift) & 0x3FU; };
  return {planeByte, static_cast<char>(firstPlaneByte2 + sixBits(12)),
          static_cast<char>(continuation + sixBits(6)), static_cast<char>(continuation + sixBits(0))};
}

bool isStandIn(std::string_view text) {
  constexpr unsigned lastPlaneByte2 = 0xBF;
  return text.size() >= standInSize && text[0] == planeByte &&
         static_cast<unsigned char>(text[1]) >= firstPlaneByte2 &&
         static_cast<unsigned char>(text[1]) <= lastPlaneByte2;
}

/// The text with what looks like one of our characters moved to plane 16, which is as private and whose
/// characters are as long.
std::string withoutStandIns(std::string_view text) {
  constexpr char nextPlaneByte = '\xF4';
  constexpr unsigned between = firstPlaneByte2 - continuation;
  std::string own(text);
  for (auto at = own.find(planeByte); at != std::string::npos; at = own.find(planeByte, at + 1))
    if (isStandIn(text.substr(at))) {
      own[at] = nextPlaneByte;
      own[at + 1] = static_cast<char>(static_cast<unsigned char>(own[at + 1]) - between);
    }
  return own;
}

/// Unicode's white space.
constexpr std::array<std::string_view, 25> spaces{
    " ",      "\t",     "\n",     "\v",     "\f",     "\r",     "\xC2\x85", "\u00A0", "\u1680",
    "\u2000", "\u2001", "\u2002", "\u2003", "\u2004", "\u2005", "\u2006",   "\u2007", "\u2008",
    "\u2009", "\u200A", "\u2028", "\u2029", "\u202F", "\u205F", "\u3000"};

/// The first space for which the test holds; null: none.
template <class Test> const std::string_view *findSpace(Test test) {
  const auto found = std::find_if(spaces.begin(), spaces.end(), test);
  return found == spaces.end() ? nullptr : &*found;
}

/// The white space that a text begins with.
std::string_view leadingSpace(std::string_view text) {
  std::size_t length = 0;
  while (const auto *space =
             findSpace([&](std::string_view each) { return text.substr(length).starts_with(each); }))
    length += space->size();
  return text.substr(0, length);
}

/// The white space that a text ends with.
std::string_view trailingSpace(std::string_view text) {
  std::size_t begin = text.size();
  while (const auto *space =
             findSpace([&](std::string_view each) { return text.substr(0, begin).ends_with(each); }))
    begin -= space->size();
  return text.substr(begin);
}

/// Whether the white space at one end of a text is all of the text, or reaches beyond a paragraph.
bool leavesParagraph(std::string_view space, std::string_view text) {
  return space.size() == text.size() || space.find("\n\n") != std::string_view::npos;
}

/// Finds the formulas and live values of a Markdown text.
class FormulaScanner {
public:
  explicit FormulaScanner(std::string_view text) : m_own(withoutStandIns(text)), m_text(m_own) {}

  [[nodiscard]] MarkdownWithoutFormulas scan() {
    while (m_next < m_text.size()) {
      const char character = m_text[m_next];
      if (character == '\\')
        copy(2);
      else if (character == '`' || beginsTildeFence())
        passCode();
      else if (character == '{') {
        if (!takeLiveValue())
          copy(1);
      } else if (character != '$')
        copy(1);
      else if (!takeFormula())
        copyLoneDollar();
    }
    return std::move(m_found);
  }

private:
  void copy(std::size_t count) {
    m_found.markdown += m_text.substr(m_next, count);
    m_next += count;
  }

  void copyLoneDollar() {
    m_found.loneDollars.push_back(m_next);
    copy(1);
  }

  /// Whether ~~~ begins a line here.
  [[nodiscard]] bool beginsTildeFence() const {
    return m_text.substr(m_next).starts_with("~~~") && (m_next == 0 || m_text[m_next - 1] == '\n');
  }

  void passCode() {
    const char mark = m_text[m_next];
    const std::size_t fence = std::min(m_text.find_first_not_of(mark, m_next), m_text.size()) - m_next;
    const auto close = m_text.find(m_text.substr(m_next, fence), m_next + fence);
    copy(close == std::string_view::npos ? fence : close + fence - m_next);
  }

  /// Puts the character for a formula that begins here; false if none does.
  bool takeFormula() {
    const bool isDisplayed = m_text.substr(m_next).starts_with("$$");
    auto found = latexAt(m_next, isDisplayed ? 2 : 1);
    if (found)
      add(std::move(*found), isDisplayed);
    return found.has_value();
  }

  /// The same for a live value.
  bool takeLiveValue() {
    auto found = liveValueAt(m_next);
    if (!found || isInAddress())
      return false;
    add(std::move(*found), false);
    return true;
  }

  /// A side of a formula, and where the text goes on behind it.
  struct FoundSide {
    MarkdownFormula::Side side;
    std::size_t end;
  };

  /// Adds the formula that begins here with a side.
  void add(FoundSide found, bool isDisplayed) {
    MarkdownFormula formula{{std::move(found.side)}};
    formula.large = isDisplayed || isAlone(m_next, found.end);
    m_next = found.end;
    if (!formula.large)
      takeAttached(formula);
    m_found.markdown += standInFor(m_found.formulas.size());
    m_found.formulas.push_back(std::move(formula));
  }

  /// The LaTeX that so many dollars at a place enclose.
  [[nodiscard]] std::optional<FoundSide> latexAt(std::size_t place, std::size_t dollars) const {
    const std::size_t begin = place + dollars;
    const auto end = closingDollar(begin, dollars);
    if (!end || *end == begin)
      return {};
    std::string_view latex = m_text.substr(begin, *end - begin);
    latex.remove_suffix(trailingSpace(latex).size());
    const std::size_t space = leadingSpace(latex).size();
    latex.remove_prefix(space);
    return FoundSide{{begin + space, std::string(latex)}, *end + dollars};
  }

  /// The live value whose braces begin at a place.
  [[nodiscard]] std::optional<FoundSide> liveValueAt(std::size_t place) const {
    const std::string_view braces = m_text.substr(place, longestName);
    const auto close = braces.starts_with('{') ? braces.find('}') : std::string_view::npos;
    if (close == std::string_view::npos)
      return {};
    const std::string_view name = braces.substr(1, close - 1);
    return isValueName(name)
               ? std::optional(FoundSide{{place + 1, std::string(name), true}, place + close + 1})
               : std::nullopt;
  }

  /// What the end of a line would tear off a formula, as lines may break behind every one: the rest of
  /// `$a$ = $b$`, and punctuation.
  void takeAttached(MarkdownFormula &formula) {
    takeRelated(formula);
    const auto end =
        std::min(m_text.find_first_not_of(isInAddress() ? ",.;:!?" : ",.;:!?)", m_next), m_text.size());
    formula.punctuation = m_text.substr(m_next, end - m_next);
    m_next = end;
  }

  /// Whether the next parenthesis ends the address of a link. Those of formulas are taken out by now.
  [[nodiscard]] bool isInAddress() const {
    const std::string_view before = m_found.markdown;
    const auto link = before.rfind("](");
    if (link == std::string_view::npos)
      return false;
    int depth = 0;
    for (const char character : before.substr(link + 1)) {
      depth += (character == '(') - (character == ')');
      if (depth == 0)
        return false;
    }
    return true;
  }

  /// The other side of ` = $b$` or ` = {b}`; or of ` $\approx b$`, or of ` {b}` behind LaTeX, which may be
  /// rounded.
  void takeRelated(MarkdownFormula &formula) {
    constexpr std::string_view relations = "=<>";
    const std::string_view rest = m_text.substr(m_next);
    const bool isNamed = rest.size() > 3 && rest[0] == ' ' &&
                         relations.find(rest[1]) != std::string_view::npos && rest[2] == ' ';
    if (!isNamed && !rest.starts_with(" $\\approx") && (!rest.starts_with(" {") || formula.sides[0].isLive))
      return;
    const std::size_t place = m_next + (isNamed ? 3 : 1);
    auto found = m_text[place] == '$' ? latexAt(place, 1) : liveValueAt(place);
    if (!found)
      return;
    if (isNamed)
      formula.relation = rest[1];
    formula.sides.push_back(std::move(found->side));
    m_next = found->end;
  }

  /// Where the partner of the dollars before `begin` stands; nothing if they have none in their paragraph.
  [[nodiscard]] std::optional<std::size_t> closingDollar(std::size_t begin, std::size_t dollars) const {
    for (std::size_t at = begin; at < m_text.size(); ++at) {
      if (m_text[at] == '\\')
        ++at;
      else if (m_text.substr(at).starts_with("\n\n"))
        return {};
      else if (m_text.substr(at).starts_with(dollars == 2 ? "$$" : "$"))
        return dollars == 1 && !trailingSpace(m_text.substr(begin, at - begin)).empty() ? std::nullopt
                                                                                        : std::optional(at);
    }
    return {};
  }

  /// Whether nothing else stands in the paragraph.
  [[nodiscard]] bool isAlone(std::size_t begin, std::size_t end) const {
    const std::string_view before = m_text.substr(0, begin);
    const std::string_view after = m_text.substr(end);
    return leavesParagraph(trailingSpace(before), before) && leavesParagraph(leadingSpace(after), after);
  }

  std::string m_own;
  std::string_view m_text;
  MarkdownWithoutFormulas m_found;
  std::size_t m_next = 0;
};

} // namespace

MarkdownWithoutFormulas takeFormulas(std::string_view text) { return FormulaScanner(text).scan(); }

FormulaPlace nextFormula(std::string_view text) {
  std::size_t at = std::min(text.find(planeByte), text.size());
  while (at < text.size() && !isStandIn(text.substr(at)))
    at = std::min(text.find(planeByte, at + 1), text.size());
  if (at == text.size())
    return {at, at, 0};
  const auto bits = [&](std::size_t index, unsigned base) {
    return static_cast<std::size_t>(static_cast<unsigned char>(text[at + index]) - base) & 0x3FU;
  };
  return {at, at + standInSize,
          bits(1, firstPlaneByte2) << 12U | bits(2, continuation) << 6U | bits(3, continuation)};
}

} // namespace halfspace
