#include "lessons/worked_lines.h"

#include "lessons/words.h"

namespace halfspace {
namespace {

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
  return {std::move(id), std::move(chains), std::move(sentence)};
}

WorkingLine asked(WorkingLine line, const std::vector<WrongTerm> &mistakes) {
  const Chain &chain = line.chains.back();
  if (const auto answer = exactNumber(chain.last()))
    line.blank = Blank{*answer, valuesOf(mistakes), chain};
  return line;
}

WorkingLine askedFor(const Chain &sought, const Term &form, WorkingLine line,
                     const std::vector<WrongTerm> &mistakes) {
  if (const auto answer = exactNumber(sought.sides().front()))
    line.blank = Blank{*answer, valuesOf(mistakes), sought, form};
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
