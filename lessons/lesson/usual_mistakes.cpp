#include "lessons/lesson/usual_mistakes.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/term/slips.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// The part of a sum that its shorter form lacks, with its sign taken off.
Term droppedFrom(const Term &whole, const Term &rest) {
  for (std::size_t i = 0; i < whole->parts.size(); ++i) {
    std::vector<Term> parts = whole->parts;
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
    const Term left = parts.size() == 1 ? parts.front() : sum(std::move(parts));
    if (readAlike(left, rest))
      return whole->parts[i]->kind == TermKind::Negation ? whole->parts[i]->parts[0] : whole->parts[i];
  }
  return whole;
}

std::string sentenceOf(const WrongWay &way) {
  const std::string right = plainText(way.right);
  const std::string instead = plainText(way.instead);
  switch (way.slip) {
  case Slip::ReversedDifference:
    return words("{answer} comes from {instead}. Here it must be {right}: the difference goes the other way.",
                 {{"instead", instead}, {"right", right}});
  case Slip::AddedInstead:
    return words("{answer} adds where {right} subtracts.", {{"right", right}});
  case Slip::SubtractedInstead:
    return words(
        "{answer} comes from {instead}. Here it must be {right}: a part is subtracted that is to be added.",
        {{"instead", instead}, {"right", right}});
  case Slip::DroppedPart:
    return words(
        "{answer} comes from {instead}. Here it must be {right}: {part} is left out.",
        {{"instead", instead}, {"right", right}, {"part", plainText(droppedFrom(way.right, way.instead))}});
  case Slip::UpsideDown:
    return words("{answer} is the fraction upside down: {bottom} belongs in the denominator.",
                 {{"bottom", plainText(way.right->parts[1])}});
  case Slip::Undivided:
    return words("{answer} is only the numerator: it is not divided by {divisor} yet.",
                 {{"divisor", plainText(way.right->parts[1])}});
  case Slip::NoRoot:
    return words("{answer} comes from {instead}. Here it must be {right}: the root is still to be taken.",
                 {{"instead", instead}, {"right", right}});
  case Slip::RootOfDivisor:
    return words("{answer} is divided by the root of {divisor} only.",
                 {{"divisor", plainText(way.right->parts[1])}});
  case Slip::NotSquared:
    return words("{answer} comes out with {instead} where its square belongs.", {{"instead", instead}});
  case Slip::LostSign:
    return words("{answer} leaves out the minus of {right}.", {{"right", right}});
  case Slip::OtherName:
    return words("{answer} comes out with {instead} where {right} belongs.",
                 {{"instead", instead}, {"right", right}});
  }
  return {};
}

} // namespace

std::vector<WrongTerm> usualMistakes(const Chain &chain) {
  const Term &formula = chain.formula();
  std::vector<WrongTerm> mistakes;
  for (const Term &way : {formula, multipliedOut(formula)})
    for (const WrongWay &wrong : wrongWays(way))
      mistakes.push_back({wrong.whole, sentenceOf(wrong)});
  return mistakes;
}

} // namespace halfspace
