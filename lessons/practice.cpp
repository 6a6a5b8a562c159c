#include "lessons/practice.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/written.h"
#include "lessons/text.h"
#include "lessons/typed_number.h"
#include "lessons/usual_mistakes.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

/// One character for each sign of an answer: `r` for a root.
std::string condensed(std::string_view typed) {
  std::string text(typed);
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> signs{
      {{" ", ""}, {"−", "-"}, {"·", "*"}, {"×", "*"}, {"√", "r"}, {"sqrt", "r"}}};
  for (const auto &[from, to] : signs)
    text = replacedAll(std::move(text), from, to);
  return text;
}

/// Reads sums of fractions with one root.
class AnswerReader {
public:
  explicit AnswerReader(std::string text) : m_text(std::move(text)) {}

  std::optional<Surd> read() {
    const Surd value = sum();
    return m_failed || m_at != m_text.size() ? std::nullopt : std::optional(value);
  }

private:
  /// factor · √square
  struct Product {
    Rational factor = 1;
    Rational square = 1;
  };

  bool take(char c) {
    if (m_at == m_text.size() || m_text[m_at] != c)
      return false;
    ++m_at;
    return true;
  }

  Surd sum() {
    Rational rational = 0;
    Surd root;
    int sign = 1;
    do {
      const Product term = product();
      const Surd value = Surd::root(term.square, Rational(term.factor * sign));
      if (value.isRational())
        rational += value.rationalPart();
      else if (root.isRational())
        root = value;
      else
        m_failed = true;
      sign = m_at < m_text.size() && m_text[m_at] == '-' ? -1 : 1;
    } while (take('+') || take('-'));
    return root + rational;
  }

  Product product() {
    Product result = factor();
    while (m_at < m_text.size() && std::string_view("+-)").find(m_text[m_at]) == std::string_view::npos) {
      const bool divides = take('/');
      if (!divides)
        take('*');
      const Product next = factor();
      if (divides && (next.factor == 0 || next.square == 0)) {
        m_failed = true;
        return {};
      }
      result.factor *= divides ? Rational(1 / next.factor) : next.factor;
      result.square *= divides ? Rational(1 / next.square) : next.square;
    }
    return result;
  }

  Product factor() {
    if (take('-')) {
      const Product positive = factor();
      return {Rational(-positive.factor), positive.square};
    }
    if (take('('))
      return bracketed();
    if (!take('r'))
      return {number(), 1};
    const Product under = take('(') ? bracketed() : Product{number(), 1};
    if (under.square != 1 || under.factor < 0)
      m_failed = true;
    return m_failed ? Product{} : Product{1, under.factor};
  }

  /// What follows an open bracket.
  Product bracketed() {
    const Surd inside = sum();
    if (!take(')') || (!inside.isRational() && inside.rationalPart() != 0))
      m_failed = true;
    return inside.isRational() ? Product{inside.rationalPart(), 1}
                               : Product{inside.rootFactor(), Rational(inside.radicand())};
  }

  Rational number() {
    const auto end = std::min(m_text.find_first_not_of("0123456789.", m_at), m_text.size());
    const auto value = parseRational(std::string_view(m_text).substr(m_at, end - m_at));
    m_failed = m_failed || !value;
    m_at = value ? end : m_text.size(); // nothing behind what cannot be read
    return value.value_or(0);
  }

  std::string m_text;
  std::size_t m_at = 0;
  bool m_failed = false;
};

/// Half a unit in the last place of a decimal; nothing for what is no decimal, or too short to be rounded.
std::optional<Rational> roundingOf(const std::string &text) {
  const auto point = text.find('.');
  if (point == std::string::npos || text.find_first_not_of("-0123456789.") != std::string::npos)
    return {};
  const auto first = text.find_first_of("123456789");
  const auto digits = first == std::string::npos ? 0 : text.size() - first - (first < point ? 1 : 0);
  if (digits < fewestDigits)
    return {};
  const auto places = static_cast<unsigned>(text.size() - point - 1);
  return Rational(1, Integer(2 * mp::pow(Integer(10), places)));
}

/// A typed number, which may stand for all numbers that round to it.
struct TypedNumber {
  Surd value;
  std::optional<Rational> rounding;

  [[nodiscard]] bool means(const Surd &number) const { return value == number || roundsTo(number); }
  [[nodiscard]] bool roundsTo(const Surd &number) const {
    if (!rounding || !value.isRational())
      return false;
    const Surd apart = number + Rational(-value.rationalPart());
    return (apart + *rounding).sign() >= 0 && (apart + Rational(-*rounding)).sign() <= 0;
  }
};

/// What a learner typed: one number or several.
using Answer = std::vector<TypedNumber>;

bool means(const Answer &answer, const std::vector<Surd> &numbers) {
  return std::equal(answer.begin(), answer.end(), numbers.begin(), numbers.end(),
                    [](const TypedNumber &typed, const Surd &number) { return typed.means(number); });
}

bool isExactly(const Answer &answer, const std::vector<Surd> &numbers) {
  return std::equal(answer.begin(), answer.end(), numbers.begin(), numbers.end(),
                    [](const TypedNumber &typed, const Surd &number) { return typed.value == number; });
}

/// The pieces of a list, without its parentheses.
std::vector<std::string_view> piecesOf(std::string_view text) {
  text = trimmed(text);
  const char separator = text.find(';') == std::string_view::npos ? ',' : ';';
  if (text.find(separator) != std::string_view::npos && text.starts_with('(') && text.ends_with(')'))
    text = text.substr(1, text.size() - 2);
  std::vector<std::string_view> pieces;
  for (auto end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    pieces.push_back(trimmed(text.substr(0, end)));
    text.remove_prefix(end + 1);
  }
  pieces.push_back(trimmed(text));
  return pieces;
}

std::optional<Answer> readAnswer(std::string_view text) {
  Answer answer;
  for (const std::string_view piece : piecesOf(text)) {
    const auto value = parseAnswer(piece);
    if (!value)
      return {};
    answer.push_back({*value, roundingOf(condensed(piece))});
  }
  return answer;
}

/// `{answer}` in a sentence as the learner wrote it.
std::string withAnswer(const std::string &sentence, std::string_view typed) {
  return replacedAll(sentence, "{answer}", replacedAll(std::string(trimmed(typed)), "-", "−"));
}

Term termOf(const std::vector<Surd> &numbers) {
  return numbers.size() == 1 ? Term(numbers.front()) : list({numbers.begin(), numbers.end()});
}

std::string praise(const Answer &answer, const std::vector<Surd> &truth) {
  if (isExactly(answer, truth))
    return words("Right.");
  const Term exact = termOf(truth);
  return showsRounded(exact) ? words("Right, rounded.")
                             : words("Right, rounded: {exact} is exact.", {{"exact", plainText(exact)}});
}

/// The sentence of the first usual mistake in the line's formula that comes to this.
std::optional<std::string> slipSentence(const Blank &blank, const Answer &answer) {
  if (!blank.formula)
    return {};
  for (const WrongTerm &mistake : usualMistakes(*blank.formula)) {
    const auto numbers = mistake.wrong->value ? exactNumbers(*mistake.wrong->value) : std::nullopt;
    if (numbers && means(answer, *numbers) && *numbers != blank.answer)
      return mistake.sentence;
  }
  return {};
}

std::vector<Surd> opposite(std::vector<Surd> numbers) {
  for (Surd &number : numbers)
    number = -number;
  return numbers;
}

std::string diagnosis(const Blank &blank, const Answer &answer) {
  if (answer.size() != blank.answer.size())
    return blank.answer.size() == 1 ? words("One number is asked for here.")
                                    : words("{count} numbers are asked for here: write them as (1, 2, 3).",
                                            {{"count", std::to_string(blank.answer.size())}});
  for (const Mistake &mistake : blank.mistakes)
    if (means(answer, mistake.value))
      return mistake.sentence;
  if (const auto slip = slipSentence(blank, answer))
    return *slip;
  if (means(answer, opposite(blank.answer)))
    return words("{answer} has the right size and the wrong sign.");
  return words("{answer} is not right. Put the numbers into the symbols once more.");
}

std::string sentenceForNoAnswer(const Blank &blank) {
  return blank.answer.size() == 1
             ? words("“{answer}” is not a number: write it as 10, −10/3, 3.33 or 2√43/3.")
             : words("“{answer}” is no list of numbers: write it as (1, −10/3, 2.5).");
}

} // namespace

std::optional<Fading> fadingNamed(std::string_view word) {
  if (word == "none")
    return Fading::None;
  if (word == "last")
    return Fading::Last;
  return word == "all" ? std::optional(Fading::All) : std::nullopt;
}

std::string_view nameOf(Fading fading) {
  return fading == Fading::None ? "none" : fading == Fading::Last ? "last" : "all";
}

std::set<std::string> blankLines(const Working &working, Fading fading, const std::set<std::string> &opened) {
  if (fading == Fading::None)
    return {};
  const auto &lines = working.lines;
  auto from = lines.begin();
  if (fading == Fading::Last) {
    auto last =
        std::find_if(lines.rbegin(), lines.rend(), [](const WorkingLine &line) { return line.blank; });
    if (last == lines.rend())
      last = std::find_if(lines.rbegin(), lines.rend(), hasNumbers);
    if (last == lines.rend() || opened.contains(last->id))
      return {};
    from = last.base() - 1;
  }
  std::set<std::string> blank;
  for (auto line = from; line != lines.end(); ++line)
    if (hasNumbers(*line) && !opened.contains(line->id))
      blank.insert(line->id);
  return blank;
}

std::optional<Surd> parseAnswer(std::string_view text) {
  if (text.size() > longestAnswer)
    return {};
  if (const auto mixed = parseMixed(text))
    return *mixed;
  return AnswerReader(condensed(text)).read();
}

Judgement judge(const Blank &blank, std::string_view typed) {
  const auto answer = readAnswer(typed);
  if (!answer)
    return {false, withAnswer(sentenceForNoAnswer(blank), typed.substr(0, longestAnswer)), false};
  if (means(*answer, blank.answer))
    return {true, praise(*answer, blank.answer)};
  return {false, withAnswer(diagnosis(blank, *answer), typed)};
}

} // namespace halfspace
