#include "lessons/object/letters.h"

#include "lessons/term/among_words.h"
#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"
#include "lessons/words.h"

namespace halfspace {
namespace {

/// The same name, standing for a number.
Term standingForNumber(const Term &name, const Rational &number) {
  const auto node = std::make_shared<TermNode>(*name);
  node->value = number;
  return Term(node);
}

} // namespace

Term detail::coordinateTerm(const std::string &id, bool isFree, const Symbol &letter, const Object &object,
                            std::size_t index) {
  const CoordinateSpec &spec = coordinatesOf(object)[index];
  const Term term = isFree ? given(letter, object[index], id, index) : name(letter, object[index]);
  const Term valued = numbersIn(spec.role) == 1 ? standingForNumber(term, object[index].x) : term;
  return valued.marked(coordinateId(id, spec));
}

std::string edgeName(const Symbol &from, const Symbol &to) {
  if (from.owner.empty() && to.owner.empty())
    return plainText(from) + plainText(to);
  return words("{from} to {to}", {{"from", plainText(from)}, {"to", plainText(to)}});
}

Term anyPoint() {
  return name(letter("P"), TermValue::list({Polynomial::unknown("x"), Polynomial::unknown("y"),
                                            Polynomial::unknown("z")}));
}

ExactVec3 vectorOf(const Term &term) {
  const std::vector<Surd> numbers = exactNumbers(term->value.value()).value();
  return {numbers.at(0).rationalPart(), numbers.at(1).rationalPart(), numbers.at(2).rationalPart()};
}

bool isUnit(const Term &vector) {
  const Term length = norm(vector);
  const Real *number = numberOf(length);
  return number && areEqual(*number, 1) == true;
}

std::string equation(const Term &name) { return plainText(Chain(name).then(amongWords(calculated(name)))); }

} // namespace halfspace
