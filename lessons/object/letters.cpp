#include "lessons/object/letters.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"

namespace halfspace {
namespace {

/// Of a free object it knows the coordinate that it is; what a construction made is told by that one's lines.
template <class Kind> Term coordinateTerm(const Given<Kind> &of, std::size_t index) {
  const Object object = of.object;
  const ExactVec3 &value = coordinate(object, index);
  const bool isFree = of.id.find('.') == std::string::npos;
  const Term term =
      isFree ? given(of.letters.at(index), value, of.id, index) : name(of.letters.at(index), value);
  return term.marked(coordinateId(of.id, coordinatesOf(object)[index]));
}

} // namespace

PlaneTerms termsOf(const Given<PlaneObject> &plane) {
  return {coordinateTerm(plane, 0), coordinateTerm(plane, 1)};
}

RayTerms termsOf(const Given<RayObject> &ray) { return {coordinateTerm(ray, 0), coordinateTerm(ray, 1)}; }

TriangleTerms termsOf(const Given<TriangleObject> &triangle) {
  return {coordinateTerm(triangle, 0), coordinateTerm(triangle, 1), coordinateTerm(triangle, 2)};
}

Term termOf(const Given<PointObject> &point) { return coordinateTerm(point, 0); }

Term anyPoint() {
  return name(letter("P"), TermValue::list({Polynomial::unknown("x"), Polynomial::unknown("y"),
                                            Polynomial::unknown("z")}));
}

Chain equationOf(const PlaneTerms &plane) {
  return condition(calculated(dot(plane.n, anyPoint() - plane.P0)) == 0);
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

std::string equation(const Term &name) { return plainText(withResult(name)); }

} // namespace halfspace
