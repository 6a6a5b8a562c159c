#include "lessons/worked_lines.h"

#include "lessons/words.h"

namespace halfspace {
namespace {

std::optional<std::vector<Surd>> exactNumbersOf(const Term &term) {
  return term->value ? exactNumbers(*term->value) : std::nullopt;
}

std::vector<Mistake> valuesOf(const std::vector<WrongTerm> &wrongTerms) {
  std::vector<Mistake> mistakes;
  for (const WrongTerm &each : wrongTerms)
    if (const auto value = exactNumbersOf(each.wrong))
      mistakes.push_back({*value, each.sentence});
  return mistakes;
}

} // namespace

WorkingLine line(std::string id, std::vector<Chain> chains, std::string sentence) {
  return {std::move(id), std::move(chains), std::move(sentence)};
}

WorkingLine asked(WorkingLine line, const std::vector<WrongTerm> &mistakes) {
  const Chain &chain = line.chains.back();
  if (const auto answer = exactNumbersOf(chain.last()))
    line.blank = Blank{*answer, valuesOf(mistakes), chain};
  return line;
}

WorkingLine askedFor(const Chain &sought, const Term &form, WorkingLine line,
                     const std::vector<WrongTerm> &mistakes) {
  if (const auto answer = exactNumbersOf(sought.sides().front()))
    line.blank = Blank{*answer, valuesOf(mistakes), sought, form};
  return line;
}

WrongTerm wrongSignOf(const Term &parameter) {
  const Real *value = numberOf(parameter);
  return {-parameter,
          value && sign(*value) == -1
              ? words("{answer} has lost its sign: numerator and denominator have different signs.")
              : words("{answer} has the wrong sign: the numerator goes from the start to the plane, "
                      "P₀ minus the start.")};
}

} // namespace halfspace
