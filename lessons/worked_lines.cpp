#include "lessons/worked_lines.h"

#include "lessons/term/latex.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

constexpr LatexMarks withMarks = LatexMarks::With;

std::string separated(const std::string &left, const std::string &right) {
  return left.empty() || right.empty() ? left + right : left + ",\\quad " + right;
}

std::string trimmed(std::string latex) {
  latex.erase(0, latex.find_first_not_of(' '));
  return latex;
}

/// The number, where it is exactly known.
std::optional<Surd> exactNumber(const Term &term) {
  const Real *number = numberOf(term);
  return number && number->exact() ? std::optional(*number->exact()) : std::nullopt;
}

std::vector<Mistake> valuesOf(const std::vector<WrongTerm> &wrongTerms) {
  std::vector<Mistake> mistakes;
  for (const WrongTerm &each : wrongTerms)
    if (const auto value = exactNumber(each.wrong))
      mistakes.push_back({*value, each.sentence});
  return mistakes;
}

} // namespace

WorkingLine line(std::string id, std::vector<Chain> chains, std::string sentence) {
  WorkingLine line;
  line.id = std::move(id);
  line.sentence = std::move(sentence);
  const Chain &first = chains.front();
  const std::size_t sides = first.sides().size();
  const bool alone = chains.size() == 1;
  const std::size_t result = alone && sides > first.symbolic() ? sides - 1 : sides;
  line.symbols = latexOf(first, 0, first.symbolic(), withMarks);
  line.numbers = trimmed(latexOf(first, first.symbolic(), result, withMarks));
  line.result = trimmed(latexOf(first, result, sides, withMarks));
  for (std::size_t i = 1; i < chains.size(); ++i)
    line.numbers = separated(line.numbers, latexOf(chains[i], withMarks));
  line.chains = std::move(chains);
  return line;
}

WorkingLine asked(WorkingLine line, const std::vector<WrongTerm> &mistakes) {
  const Chain &chain = line.chains.back();
  if (const auto answer = exactNumber(chain.last()))
    line.blank = Blank{*answer, valuesOf(mistakes), "=", chain};
  return line;
}

WorkingLine askedFor(const Chain &sought, const Term &form, WorkingLine line,
                     const std::vector<WrongTerm> &mistakes) {
  const Term &name = sought.sides().front();
  if (const auto answer = exactNumber(name))
    line.blank = Blank{*answer, valuesOf(mistakes),
                       separated("= " + latexOf(form, withMarks), latexOf(name, withMarks) + " ="), sought};
  return line;
}

WrongTerm wrongSignOf(const Term &parameter) {
  const auto value = exactNumber(parameter);
  return {-parameter,
          value && value->sign() < 0
              ? words("{answer} has lost its sign: numerator and denominator have different signs.")
              : words("{answer} has the wrong sign: the numerator goes from the start to the plane, "
                      "P₀ minus the start.")};
}

} // namespace halfspace
