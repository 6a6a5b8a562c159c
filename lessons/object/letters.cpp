#include "lessons/object/letters.h"

#include "lessons/term/plain_text.h"
#include "lessons/term/rewrite.h"

namespace halfspace {
namespace {

Term corner(const std::string &index, const ExactVec3 &at, const std::string &role, std::size_t coordinate) {
  return given(letter("P", index), at, role, coordinate).marked("P" + index);
}

} // namespace

Symbol symbolOf(std::string_view name) {
  const auto lastLetter = name.find_last_not_of("0123456789");
  const std::string letters(name.substr(0, lastLetter + 1));
  Symbol symbol = letters.size() > 1 ? word(letters) : letter(letters);
  symbol.subscript = name.substr(letters.size());
  return symbol;
}

PlaneTerms termsOf(const PlaneObject &plane, const std::string &role) {
  return {given(letter("P", "0"), plane.point, role, 0).marked("P0"),
          given(vectorLetter("n"), plane.normal, role, 1).marked("n")};
}

RayTerms termsOf(const RayObject &ray, const std::string &role) {
  return {given(letter("Q"), ray.origin, role, 0).marked("Q"),
          given(vectorLetter("r"), ray.direction, role, 1).marked("r")};
}

TriangleTerms termsOf(const TriangleObject &triangle, const std::string &role) {
  return {corner("0", triangle.p0, role, 0), corner("1", triangle.p1, role, 1),
          corner("2", triangle.p2, role, 2)};
}

Term termOf(const PointObject &point, const std::string &role) {
  return given(letter(role), point.at, role, 0).marked(role);
}

Term anyPoint() {
  return name(letter("P"), TermValue::list({Polynomial::unknown("x"), Polynomial::unknown("y"),
                                            Polynomial::unknown("z")}));
}

Chain equationOf(const PlaneObject &plane) {
  const PlaneTerms E = termsOf(plane, "E");
  return condition(calculated(dot(E.n, anyPoint() - E.P0)) == 0);
}

bool isUnit(const Term &vector) {
  const Term length = norm(vector);
  const Real *number = numberOf(length);
  return number && areEqual(*number, 1) == true;
}

std::string equation(const Term &name) { return plainText(withResult(name)); }

} // namespace halfspace
