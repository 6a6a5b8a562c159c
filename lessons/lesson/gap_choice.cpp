#include "lessons/lesson/gap_choice.h"

#include <algorithm>

namespace halfspace {
namespace {

/// Gaps in a term that is calculated; `entry`: it stands there in a list.
void collectGaps(const Term &term, std::optional<std::size_t> entry, std::vector<Gap> &gaps) {
  const bool isNumber = term->kind == TermKind::Number;
  if (term->value && isExact(*term->value) && (isNumber || term->kind == TermKind::List))
    gaps.push_back({term, false, entry});
  if (isNumber)
    return;
  for (std::size_t i = 0; i < term->parts.size(); ++i)
    collectGaps(term->parts[i], term->kind == TermKind::List ? std::optional(i) : std::nullopt, gaps);
}

/// Whether the number is worked out by a formula that stands in the line, and by no name or coordinate alone.
bool isWorkedOut(const Gap &gap) {
  const auto &origin = gap.hidden->origin;
  return origin && !gap.hidden->source && (*origin)->kind != TermKind::Name &&
         (*origin)->kind != TermKind::Applied;
}

/// What a name stands for; other terms as they are.
const Term &meaning(const Term &term) {
  return term->kind == TermKind::Name && term->origin ? *term->origin : term;
}

/// Whether the chain says in symbols what the term is.
bool says(const Chain &chain, const Term &term) {
  const auto symbols = chain.symbols();
  return chain.isIdentity() &&
         std::any_of(symbols.begin(), symbols.end(), [&](const Term &side) { return readAlike(side, term); });
}

/// Whether both formulas are the same, or a line says that they come to the same: f(Q) = n·(Q − P₀).
bool areOneQuantity(const Term &a, const Term &b, const Working &working) {
  const auto saysBoth = [&](const Chain &chain) { return says(chain, a) && says(chain, b); };
  return readAlike(meaning(a), meaning(b)) ||
         std::any_of(working.lines.begin(), working.lines.end(), [&](const WorkingLine &line) {
           return std::any_of(line.chains.begin(), line.chains.end(), saysBoth);
         });
}

bool isPartOf(const Term &part, const Term &whole) {
  return &*part == &*whole || (whole->kind != TermKind::Number &&
                               std::any_of(whole->parts.begin(), whole->parts.end(),
                                           [&](const Term &each) { return isPartOf(part, each); }));
}

/// Whether two numbers of one formula are the same part of what it comes to.
bool areSamePart(const Gap &a, const Gap &b) {
  return a.entry && b.entry ? a.entry == b.entry : areEqual(*a.hidden->value, *b.hidden->value) != false;
}

/// Whether what is written tells what is left out; not where it is the same number on the page.
bool tells(const Gap &written, const Gap &gap, const Working &working) {
  const auto &formula = gap.hidden->origin;
  const auto &other = written.hidden->origin;
  return &*written.hidden != &*gap.hidden && formula && other && areSamePart(gap, written) &&
         areOneQuantity(*formula, *other, working);
}

std::vector<Gap> numbersIn(const Working &working) {
  std::vector<Gap> numbers;
  for (const WorkingLine &line : working.lines)
    for (const Chain &chain : line.chains)
      for (Gap &gap : numberGaps(chain))
        numbers.push_back(std::move(gap));
  return numbers;
}

/// The term with another in the place of a part.
Term replaced(const Term &term, const Term &part, const Term &other) {
  if (&*term == &*part)
    return other;
  if (!isPartOf(part, term))
    return term;
  std::vector<Term> parts;
  parts.reserve(term->parts.size());
  for (const Term &each : term->parts)
    parts.push_back(replaced(each, part, other));
  return withParts(term, std::move(parts));
}

/// A number of another magnitude, so that its square is another too; or a list in which each number has
/// become another one, by an amount of its own, so that its products with other lists are others too.
Term anotherThan(const Term &given, int by = 1) {
  if (given->kind == TermKind::List) {
    std::vector<Term> entries;
    entries.reserve(given->parts.size());
    for (const Term &entry : given->parts)
      entries.push_back(anotherThan(entry, by++));
    return withParts(given, std::move(entries));
  }
  const Real *value = numberOf(given);
  return value && sign(*value) == -1 ? given - by : given + by;
}

/// Whether the chain tells a wrong answer from the right one.
bool tries(const Chain &chain, const Term &given) {
  const Term other = anotherThan(given);
  return std::any_of(chain.sides().begin(), chain.sides().end(), [&](const Term &side) {
    if (!isPartOf(given, side))
      return false;
    const auto changed = replaced(side, given, other)->value;
    return !changed || !side->value || areEqual(*changed, *side->value) != true;
  });
}

/// One for each line, whatever its numbers are.
std::size_t numberOfItsOwn(const WorkingLine &line) {
  std::size_t sum = 0;
  for (const char c : line.id)
    sum += static_cast<unsigned char>(c);
  return sum;
}

} // namespace

std::vector<Gap> numberGaps(const Chain &chain) {
  std::vector<Gap> gaps;
  for (std::size_t side = chain.symbolic(); side < chain.sides().size(); ++side)
    collectGaps(chain.sides()[side], {}, gaps);
  return gaps;
}

GapChoice::GapChoice(const Working &working) : m_working(working), m_written(numbersIn(working)) {}

std::optional<Gap> GapChoice::of(const WorkingLine &line) const {
  if (line.chains.size() > 1)
    return {};
  const auto isTold = [&](const Gap &gap) {
    return std::any_of(m_written.begin(), m_written.end(),
                       [&](const Gap &each) { return tells(each, gap, m_working); });
  };
  std::vector<Gap> gaps = numberGaps(askedChain(line));
  std::erase_if(gaps, [&](const Gap &gap) { return !isWorkedOut(gap) || isTold(gap); });
  if (gaps.empty())
    return {};
  const auto usual = gaps.begin() + static_cast<std::ptrdiff_t>(numberOfItsOwn(line) % gaps.size());
  std::rotate(gaps.begin(), usual, gaps.end());
  const auto found = std::find_if(gaps.begin(), gaps.end(),
                                  [&](const Gap &gap) { return tries(askedChain(line), gap.hidden); });
  return found == gaps.end() ? std::nullopt : std::optional(*found);
}

} // namespace halfspace
