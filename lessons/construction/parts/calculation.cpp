#include "lessons/construction/parts/calculation.h"

#include "lessons/construction/parts/worked_lines.h"
#include "lessons/term/plain_text.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {

WorkingLine lineOf(const Step &step, bool canDivide) {
  if (canDivide || step.needs == Needs::Nothing)
    return asked(step.numbers(step.chain), step.sentence, step.mistakes);
  const Term &quotient = step.chain.formula();
  return line({withResult(quotient->parts[0]), withResult(quotient->parts[1])},
              words("{quotient}, which would be {letter}, is not defined: nothing can be divided by 0.",
                    {{"quotient", plainText(quotient)}, {"letter", plainText(step.chain.sides().front())}}));
}

Cost costOf(const Steps &steps, std::vector<Term> changing) {
  OperationCounter counter;
  Cost cost;
  const auto isChanging = [&](const Term &name) {
    return std::any_of(changing.begin(), changing.end(),
                       [&](const Term &each) { return readAlike(each, name); });
  };
  for (const Step &step : steps) {
    const Term &formula = step.chain.formula();
    const std::vector<Term> names = namesIn(formula);
    const bool changes = std::any_of(names.begin(), names.end(), isChanging);
    if (changes)
      changing.push_back(step.chain.sides().front());
    (changes ? cost.eachTime : cost.once) += counter.add(formula);
  }
  return cost;
}

} // namespace halfspace
