#include "lessons/construction/worked_lines.h"

#include "lessons/words.h"

namespace halfspace {
namespace {

WorkingLine asking(Asked what, std::string id, const Chain &chain, std::string sentence,
                   std::vector<WrongTerm> mistakes) {
  WorkingLine asked = line(std::move(id), chain, std::move(sentence));
  const auto &answer = chain.last()->value;
  if (!answer || !isExact(*answer) || (what == Asked::Equation && !answer->entries.front().hasUnknowns()))
    return asked; // nobody could type it
  asked.asked = what;
  asked.mistakes = std::move(mistakes);
  return asked;
}

} // namespace

WorkingLine line(std::string id, const Chain &chain, std::string sentence) {
  return line(std::move(id), std::vector{chain}, std::move(sentence));
}

WorkingLine line(std::string id, std::vector<Chain> chains, std::string sentence) {
  return {std::move(id), std::move(chains), std::move(sentence)};
}

WorkingLine asked(std::string id, const Chain &chain, std::string sentence, std::vector<WrongTerm> mistakes) {
  return asking(Asked::Value, std::move(id), chain, std::move(sentence), std::move(mistakes));
}

WorkingLine askedEquation(std::string id, const Chain &chain, std::string sentence,
                          std::vector<WrongTerm> mistakes) {
  return asking(Asked::Equation, std::move(id), chain, std::move(sentence), std::move(mistakes));
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
