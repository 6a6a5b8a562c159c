#include "lessons/construction/parts/worked_lines.h"

#include "lessons/words.h"

namespace halfspace {
namespace {

WorkingLine asking(Asked what, const Chain &chain, std::string sentence, std::vector<WrongTerm> mistakes) {
  WorkingLine asked = line(chain, std::move(sentence));
  const auto &answer = chain.last()->value;
  if (!answer || !isExact(*answer) || (what == Asked::Equation && !answer->entries.front().hasUnknowns()))
    return asked; // nobody could type it
  asked.asked = what;
  asked.mistakes = std::move(mistakes);
  return asked;
}

} // namespace

WorkingLine line(const Chain &chain, std::string sentence) {
  return line(std::vector{chain}, std::move(sentence));
}

WorkingLine line(std::vector<Chain> chains, std::string sentence) {
  return {.chains = std::move(chains), .sentence = std::move(sentence)};
}

WorkingLine resultsLine(const std::vector<Term> &terms, std::string sentence) {
  std::vector<Chain> chains;
  chains.reserve(terms.size());
  for (const Term &term : terms)
    chains.push_back(withResult(term));
  return line(std::move(chains), std::move(sentence));
}

WorkingLine asked(const Chain &chain, std::string sentence, std::vector<WrongTerm> mistakes) {
  return asking(Asked::Value, chain, std::move(sentence), std::move(mistakes));
}

WorkingLine askedEquation(const Chain &chain, std::string sentence, std::vector<WrongTerm> mistakes) {
  return asking(Asked::Equation, chain, std::move(sentence), std::move(mistakes));
}

WrongTerm wrongSignOf(const Term &parameter, const Naming &naming) {
  const Real *value = numberOf(parameter);
  return {-parameter,
          value && sign(*value) == -1
              ? words("{answer} has lost its sign: numerator and denominator have different signs.")
              : words("{answer} has the wrong sign: the numerator goes from the start to the plane, "
                      "{P0} minus the start.",
                      naming.letters)};
}

} // namespace halfspace
