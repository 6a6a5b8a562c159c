#include "lessons/object/drawing.h"

#include "lessons/term/latex.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {

Place place(const Term &term) {
  const std::vector<Polynomial> &entries = term->value.value().entries;
  return {toDouble(entries.at(0).constant()), toDouble(entries.at(1).constant()),
          toDouble(entries.at(2).constant())};
}

MarkBase drawn(const Term &letter, Role role, Subject subject) {
  return {letter->mark, role, subject, latexOf(letter)};
}

PointMark pointOf(const Term &letter, Role role, Subject subject) {
  return {drawn(letter, role, subject), place(letter)};
}

ArrowMark arrowOf(const Term &letter, const Place &from, Role role, Subject subject) {
  return {drawn(letter, role, subject), from, place(letter)};
}

Place unitOf(const ExactVec3 &direction) {
  // The largest coordinate is made 1 first: the squares of a very short direction's doubles would vanish.
  const auto size = [](const Rational &x) { return abs(x); };
  const Rational largest = std::max({size(direction.x), size(direction.y), size(direction.z)});
  return glm::normalize(place(direction * Rational(1 / largest)));
}

ArrowMark arrowOfLength(MarkBase base, const Place &from, const ExactVec3 &direction, double length) {
  return {std::move(base), from, unitOf(direction) * length};
}

} // namespace halfspace
