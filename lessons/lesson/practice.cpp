#include "lessons/lesson/practice.h"

#include "lessons/language.h"
#include "lessons/lesson/usual_mistakes.h"
#include "lessons/reading/typed_answer.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/term/written.h"
#include "lessons/text.h"
#include "lessons/words.h"

#include <algorithm>
#include <array>

namespace halfspace {
namespace {

/// In the order of Fading.
constexpr std::array<std::string_view, 4> fadingNames{"none", "gaps", "last", "all"};

/// `{answer}` in a sentence as the learner wrote it.
std::string withAnswer(const std::string &sentence, std::string_view typed) {
  return replacedAll(sentence, "{answer}", replacedAll(std::string(trimmed(typed)), "-", "−"));
}

void addLetters(const std::vector<Polynomial> &entries, std::set<std::string> &letters) {
  for (const Polynomial &entry : entries)
    for (const Polynomial::Summand &summand : entry.summands())
      letters.insert(summand.monomial.begin(), summand.monomial.end());
}

std::set<std::string> lettersIn(const std::vector<Polynomial> &entries) {
  std::set<std::string> letters;
  addLetters(entries, letters);
  return letters;
}

/// The unknowns of a formula, those included that drop out when it is calculated.
void addLetters(const Term &formula, std::set<std::string> &letters) {
  if (formula->value)
    addLetters(formula->value->entries, letters);
  for (const Term &part : formula->parts)
    addLetters(part, letters);
}

/// x, y, z
std::string listed(const std::set<std::string> &letters) {
  std::string list;
  for (const std::string &letter : letters)
    list += (list.empty() ? "" : ", ") + letter;
  return list;
}

/// As a learner types it: (1, 2, 3)
std::string listOf(std::initializer_list<std::string> entries) {
  std::string list;
  for (const std::string &entry : entries)
    list += (list.empty() ? "(" : listSeparator() + std::string(" ")) + entry;
  return list + ")";
}

/// What is asked for in a gap, and how answers are compared with it.
class AskedGap {
public:
  AskedGap(const WorkingLine &line, const Gap &gap)
      : m_gap(gap), m_truth(gap.hidden->value.value()),
        m_isEquation(gap.isResult && line.asked == Asked::Equation),
        m_isBehindMinus(!gap.isResult && isBehindMinus(gap.hidden, askedChain(line))) {
    if (gap.isResult)
      m_mistakes = line.mistakes;
    addLetters(m_truth.entries, m_letters);
    if (gap.isResult && !m_letters.empty())
      addLetters(askedChain(line).formula(), m_letters);
    const auto formula = gap.isResult ? std::optional(askedChain(line)) : gap.hidden->origin;
    if (formula)
      for (WrongTerm &mistake : usualMistakes(*formula))
        m_mistakes.push_back(std::move(mistake));
  }

  [[nodiscard]] bool isRight(const TypedAnswer &answer) const { return isMeant(answer, m_truth); }

  [[nodiscard]] std::string praise(const TypedAnswer &answer) const {
    if (areEqual(answer.value(), m_truth) == true || (answer.isEquation && !m_isEquation))
      return words("Right.");
    if (m_isEquation)
      return words("Right: the same equation, all its numbers multiplied by the same factor.");
    const Term exact = calculated(m_gap.hidden);
    return showsRounded(exact) ? words("Right, rounded.")
                               : words("Right, rounded: {exact} is exact.", {{"exact", plainText(exact)}});
  }

  /// How many numbers are asked for.
  [[nodiscard]] std::size_t count() const { return m_truth.entries.size(); }
  [[nodiscard]] bool hasAsManyNumbers(const TypedAnswer &answer) const {
    return answer.entries.size() == count();
  }

  /// What is wrong with an answer of as many numbers as are asked for.
  [[nodiscard]] std::string diagnosis(const TypedAnswer &answer) const {
    const bool isOpposite = !m_isEquation && answer.means(opposite(m_truth));
    if (isOpposite && m_isBehindMinus)
      return words("The minus stands before the gap already: leave it out here.");
    for (const WrongTerm &mistake : m_mistakes)
      if (const auto value = valueOf(mistake); value && isMistake(answer, *value) && !isTruth(*value))
        return mistake.sentence;
    if (m_isEquation && answer.meansEquation(withOppositeNumber(m_truth)))
      return words("{answer} is right but for the sign of the number that stands alone.");
    if (isOpposite)
      return words("{answer} has the right size and the wrong sign.");
    return m_gap.isResult ? words("{answer} is not right. Put the numbers into the symbols once more.")
                          : words("{answer} is not right. Work it out once more.");
  }

  [[nodiscard]] std::string sentenceForAnotherCount(const TypedAnswer &answer) const {
    if (m_truth.isList)
      return words("{count} numbers are asked for here: write them as {list}.",
                   {{"count", std::to_string(m_truth.entries.size())}, {"list", listOf({"1", "2", "3"})}});
    if (!m_letters.empty())
      return words("One equation is asked for here.");
    const bool hasDecimalComma = answer.entries.size() == 2; // as it seems
    return hasDecimalComma ? words("One number is asked for here: a decimal is written as {decimal}.",
                                   {{"decimal", withDecimalMark("2.5")}})
                           : words("One number is asked for here.");
  }

  [[nodiscard]] std::string sentenceForNoAnswer() const {
    if (!m_letters.empty())
      return words("“{answer}” cannot be read: write it with {letters} and numbers, as 2{letter} − 1/3 = 0.",
                   {{"letters", listed(m_letters)}, {"letter", *m_letters.begin()}});
    return m_truth.isList ? words("“{answer}” is no list of numbers: write it as {list}.",
                                  {{"list", listOf({"1", "−10/3", withDecimalMark("2.5")})}})
                          : words("“{answer}” is not a number: write it as 10, −10/3, {decimal} or 2√43/3.",
                                  {{"decimal", withDecimalMark("3.33")}});
  }

  /// Whether the answer is of the kind that is asked for: no letters but those that are there.
  [[nodiscard]] bool canBe(const TypedAnswer &answer) const {
    const std::set<std::string> typed = lettersIn(answer.value().entries);
    return (!answer.isEquation || !m_letters.empty()) &&
           std::includes(m_letters.begin(), m_letters.end(), typed.begin(), typed.end());
  }

private:
  [[nodiscard]] bool isMeant(const TypedAnswer &answer, const TermValue &value) const {
    if (m_isEquation)
      return answer.meansEquation(value);
    // Either side of an equation may be the one with the zero.
    return answer.means(value) || (answer.isEquation && answer.means(opposite(value)));
  }
  /// What was typed without an equals sign is compared as it stands: as an equation −2t + 12 = 0 would be
  /// 2t − 12 = 0, by which another mistake was made.
  [[nodiscard]] bool isMistake(const TypedAnswer &answer, const TermValue &value) const {
    return m_isEquation && !answer.isEquation ? answer.means(value) : isMeant(answer, value);
  }
  [[nodiscard]] bool isTruth(const TermValue &value) const {
    return m_isEquation ? TypedAnswer{{{value.entries.front()}}}.meansEquation(m_truth)
                        : areEqual(value, m_truth) != false;
  }

  /// What a mistake comes to; of a number in a list, its entry.
  [[nodiscard]] std::optional<TermValue> valueOf(const WrongTerm &mistake) const {
    const auto &value = mistake.wrong->value;
    if (!value || !m_gap.entry)
      return value;
    return value->isList && *m_gap.entry < value->entries.size()
               ? std::optional(TermValue(value->entries[*m_gap.entry]))
               : std::nullopt;
  }

  /// Of one side of an equation: 2t + 12 for 2t − 12.
  static TermValue withOppositeNumber(TermValue value) {
    Polynomial &side = value.entries.front();
    side = side - side.constant() - side.constant();
    return value;
  }

  static TermValue opposite(TermValue value) {
    for (Polynomial &entry : value.entries)
      entry = -entry;
    return value;
  }

  const Gap &m_gap;
  TermValue m_truth;
  bool m_isEquation;
  bool m_isBehindMinus;            ///< in the line, the gap
  std::set<std::string> m_letters; ///< that the answer may have
  std::vector<WrongTerm> m_mistakes;
};

using Lines = SharedList<WorkingLine>;

Lines::const_iterator firstFaded(const Lines &lines, Fading fading) {
  if (fading != Fading::Last)
    return fading == Fading::All ? lines.begin() : lines.end();
  const auto last = std::find_if(lines.rbegin(), lines.rend(),
                                 [](const WorkingLine &line) { return line.asked != Asked::Nothing; });
  return last == lines.rend() ? lines.end() : last.base() - 1;
}

/// Whether the chain begins with the term: `n·n` or `f(Q)`, the value of which it says.
bool says(const WorkingLine &line, const Term &term) {
  return std::any_of(line.chains.begin(), line.chains.end(),
                     [&](const Chain &chain) { return readAlike(chain.sides().front(), term); });
}

/// What must be known to work a formula out. What max(a, b) comes to is for the learner to find.
std::vector<Term> namesToBeKnown(const Term &formula) {
  std::vector<Term> names;
  for (const Term &name : namesIn(formula))
    if (name->kind == TermKind::Applied && name->parts.front()->kind == TermKind::List)
      for (const Term &inner : namesIn(name->parts.front()))
        names.push_back(inner);
    else
      names.push_back(name);
  return names;
}

/// Whether the line begins with what a line with a gap is about: cos θ < 1 beside cos θ = 1/2.
bool repeatsOneOf(const WorkingLine &line, const std::map<std::string, Gap> &gaps, const Working &working) {
  return std::any_of(gaps.begin(), gaps.end(), [&](const auto &each) {
    const auto symbols = askedChain(*findLine(working, each.first)).symbols();
    return std::any_of(symbols.begin(), symbols.end(), [&](const Term &side) { return says(line, side); });
  });
}

} // namespace

std::optional<Fading> fadingNamed(std::string_view word) {
  const auto found = std::find(fadingNames.begin(), fadingNames.end(), word);
  return found == fadingNames.end() ? std::nullopt
                                    : std::optional(static_cast<Fading>(found - fadingNames.begin()));
}

Gap resultGap(const WorkingLine &line) { return {askedChain(line).last()}; }

Fade fade(const Working &working, Fading fading, const std::set<std::string> &opened) {
  Fade faded;
  if (fading == Fading::Gaps) {
    const GapChoice choice(working);
    for (const WorkingLine &line : working.lines)
      if (const auto gap = opened.contains(line.id) ? std::nullopt : choice.of(line))
        faded.gaps.emplace(line.id, *gap);
    for (const WorkingLine &line : working.lines)
      if (line.asked == Asked::Nothing && !faded.gaps.contains(line.id) &&
          repeatsOneOf(line, faded.gaps, working))
        faded.waiting.insert(line.id);
    return faded;
  }
  const auto &lines = working.lines;
  for (auto line = firstFaded(lines, fading); line != lines.end(); ++line)
    if (line->asked != Asked::Nothing && !opened.contains(line->id))
      faded.gaps.emplace(line->id, resultGap(*line));
    else if (line->asked == Asked::Nothing && !faded.gaps.empty() && hasNumbers(*line))
      faded.waiting.insert(line->id);
  return faded;
}

Fade withheld(const Working &working) {
  Fade fade;
  for (const WorkingLine &line : working.lines)
    if (hasNumbers(line))
      fade.waiting.insert(line.id);
  return fade;
}

WorkingLine asDemand(WorkingLine line) {
  for (Chain &chain : line.chains)
    chain = chain.asDemand();
  return line;
}

std::string questionText(const WorkingLine &line, const Gap &gap) {
  return gap.isResult ? symbolsText(line) : plainTextWithout(gap.hidden, askedChain(line));
}

std::vector<Chain> toldFor(const WorkingLine &line, const Gap &gap, const Working &shown) {
  const std::optional<Term> formula = gap.isResult ? askedChain(line).formula() : gap.hidden->origin;
  std::vector<Chain> told;
  if (!formula)
    return told;
  for (const Term &name : namesToBeKnown(*formula))
    if (name->value && std::none_of(shown.lines.begin(), shown.lines.end(),
                                    [&](const WorkingLine &each) { return says(each, name); }))
      told.push_back(withResult(name));
  return told;
}

Judgement judge(const WorkingLine &line, const Gap &gap, std::string_view typed) {
  const AskedGap asked(line, gap);
  const auto answer = readAnswer(typed, language().decimalMark, asked.count());
  if (!answer || !asked.canBe(*answer))
    return {false, withAnswer(asked.sentenceForNoAnswer(), shortened(typed)), false};
  if (asked.isRight(*answer))
    return {true, asked.praise(*answer)};
  if (!asked.hasAsManyNumbers(*answer))
    return {false, withAnswer(asked.sentenceForAnotherCount(*answer), typed), false};
  return {false, withAnswer(asked.diagnosis(*answer), typed)};
}

} // namespace halfspace
