#include "lessons/typed/mend_line.h"

#include "lessons/formula/read_formula.h"
#include "lessons/guess.h"
#include "lessons/text.h"
#include "lessons/typed/call_words.h"
#include "lessons/typed/look_words.h"
#include "lessons/typed/read_line.h"
#include "lessons/typed/scene_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

namespace halfspace {
namespace {

/// What is tried, the likeliest slips first: the marks of another language, of the fingers where the fault
/// is, then anywhere, then a wrong choice.
enum class Slip {
  OfAllMarks,
  OfAWord,
  OfOrderHere,
  OfASignHere,
  OfAnotherSignHere,
  OfOrder,
  OfASign,
  OfAnotherSign,
  OfAnObject
};

/// Signs that are forgotten, doubled or mistaken for others.
constexpr std::array<std::string_view, 9> signs{"(", ")", ",", "=", "+", "-", "/", ".", "*"};
/// So near to a fault the slip is that makes it, in bytes.
constexpr std::size_t near = 3;
/// In longer lines there is too much to be tried.
constexpr std::size_t longestMended = 200;
constexpr std::string_view stepWord = "step";

bool isOfWord(char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-'; }

/// A part of a line: [begin, end).
struct LinePart {
  std::size_t begin;
  std::size_t end;
};

std::vector<LinePart> wordsIn(std::string_view line) {
  std::vector<LinePart> found;
  for (std::size_t begin = 0; begin < line.size();) {
    std::size_t end = begin;
    while (end < line.size() && isOfWord(line[end]))
      ++end;
    if (end > begin && isLetter(line[begin]))
      found.push_back({begin, end});
    begin = std::max(end, begin + 1);
  }
  return found;
}

/// Collects lines that may have been meant.
class Mender {
public:
  Mender(std::string_view line, const Scene &above, char decimalMark)
      : m_line(line), m_above(above), m_mark(decimalMark), m_names(above) {}

  std::vector<std::string> mend(std::size_t most) {
    const auto read = readLine(m_line, m_above, m_mark);
    const auto *fault = std::get_if<TypedFault>(&read);
    if (!fault || m_line.size() > longestMended)
      return {};
    addOtherMarks();
    addWhatIsMissing();
    addFreeName();
    addNearWords();
    for (std::size_t place = 0; place <= m_line.size(); ++place)
      addSlipsOfFingers(place, isNear(place, *fault));
    addObjects(*fault);
    std::stable_sort(m_tries.begin(), m_tries.end(),
                     [](const Try &a, const Try &b) { return a.slip < b.slip; });
    return thatRead(most);
  }

private:
  struct Try {
    Slip slip;
    std::string line;
  };

  void add(Slip slip, LinePart part, std::string_view by) {
    std::string line(m_line);
    line.replace(part.begin, part.end - part.begin, by);
    m_tries.push_back({slip, std::move(line)});
  }

  /// The end of an equation, or the brackets around three numbers.
  void addWhatIsMissing() {
    const std::size_t sign = m_line.find_first_of("=:");
    if (sign == std::string_view::npos)
      return;
    if (m_line[sign] == ':' && m_line.find('=') == std::string_view::npos)
      m_tries.push_back({Slip::OfAllMarks, std::string(m_line) + " = 0"});
    m_tries.push_back({Slip::OfAllMarks, std::string(m_line.substr(0, sign + 1)) + " (" +
                                             std::string(trimmed(m_line.substr(sign + 1))) + ")"});
  }

  /// Numbers as another language writes them: (0,5; 1; 2) for (0.5, 1, 2), or the other way round.
  void addOtherMarks() {
    const bool hasPoints = m_mark == '.';
    std::string line(m_line);
    for (char &sign : line)
      if (sign == ',')
        sign = hasPoints ? '.' : ';';
      else if (sign == (hasPoints ? ';' : '.'))
        sign = ',';
    m_tries.push_back({Slip::OfAllMarks, std::move(line)});
  }

  /// Q_1 where there is a Q.
  void addFreeName() {
    const std::vector<LinePart> found = wordsIn(m_line);
    if (found.empty() || found.front().begin != 0)
      return;
    const std::string name(m_line.substr(0, found.front().end));
    if (m_names.isFree(name))
      return;
    int number = 1;
    while (!m_names.isFree(name + "_" + std::to_string(number)))
      ++number;
    add(Slip::OfAWord, found.front(), name + "_" + std::to_string(number));
  }

  /// The nearest name and the nearest word for each word that is none, the one with the fault first.
  void addNearWords() {
    std::vector<std::string> known = m_names.names();
    known.insert(known.end(), callWords().begin(), callWords().end());
    known.emplace_back(stepWord);
    known.emplace_back(shortestWord);
    for (const std::string &word : lookWords())
      known.push_back(word);
    for (const LinePart &part : wordsIn(m_line)) {
      const std::string word(m_line.substr(part.begin, part.end - part.begin));
      if (part.begin == 0 || std::find(known.begin(), known.end(), word) != known.end())
        continue;
      if (const std::string nearest = nearestOf(word, known); !nearest.empty())
        add(Slip::OfAWord, part, nearest);
      for (const std::string &name : known)
        if (std::equal(name.begin(), name.end(), word.begin(), word.end(),
                       [](char a, char b) { return std::tolower(a) == std::tolower(b); }))
          add(Slip::OfAWord, part, name);
    }
  }

  [[nodiscard]] bool isNear(std::size_t place, const TypedFault &fault) const {
    return (place + near >= fault.at && place <= fault.at + fault.length + near) || place == m_line.size();
  }

  /// Two signs in the wrong order or one twice; a sign too many or too few; another sign. No sign but =
  /// belongs to the name, which would be another one then.
  void addSlipsOfFingers(std::size_t place, bool isHere) {
    const bool isInName = place <= m_line.find_first_of(" =:");
    for (const std::string_view sign : signs)
      if (!isInName || sign == "=")
        add(isHere ? Slip::OfASignHere : Slip::OfASign, {place, place}, sign);
    if (place == m_line.size())
      return;
    const char here = m_line[place];
    const char next = place + 1 < m_line.size() ? m_line[place + 1] : here;
    add(here == next ? (isHere ? Slip::OfOrderHere : Slip::OfOrder)
                     : (isHere ? Slip::OfASignHere : Slip::OfASign),
        {place, place + 1}, "");
    if (place + 1 < m_line.size())
      add(isHere ? Slip::OfOrderHere : Slip::OfOrder, {place, place + 2}, std::string{next, here});
    if (!isOfWord(here) && here != ' ')
      for (const std::string_view sign : signs)
        add(isHere ? Slip::OfAnotherSignHere : Slip::OfAnotherSign, {place, place + 1}, sign);
  }

  /// Another object in the place of the one that does not fit.
  void addObjects(const TypedFault &fault) {
    if (fault.length == 0)
      return;
    std::set<std::string_view> inLine;
    for (const LinePart &part : wordsIn(m_line))
      inLine.insert(m_line.substr(part.begin, part.end - part.begin));
    for (const std::string &name : m_names.names())
      if (!inLine.contains(name))
        add(Slip::OfAnObject, {fault.at, fault.at + fault.length}, name);
  }

  [[nodiscard]] std::vector<std::string> thatRead(std::size_t most) const {
    std::vector<std::string> found;
    std::set<std::string> tried;
    for (const Try &each : m_tries) {
      if (found.size() == most)
        break;
      if (tried.insert(each.line).second &&
          std::holds_alternative<Entry>(readLine(each.line, m_above, m_mark)))
        found.push_back(each.line);
    }
    return found;
  }

  std::string_view m_line;
  const Scene &m_above;
  char m_mark;
  SceneNames m_names;
  std::vector<Try> m_tries;
};

} // namespace

std::vector<std::string> mendsOf(std::string_view line, const Scene &above, char decimalMark,
                                 std::size_t most) {
  return Mender(line, above, decimalMark).mend(most);
}

} // namespace halfspace
