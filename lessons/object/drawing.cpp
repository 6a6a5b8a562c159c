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

bool isFlatAndConvex(const std::vector<ExactVec3> &corners) {
  const std::size_t count = corners.size();
  const ExactVec3 normal = cross(corners[1] - corners[0], corners[2] - corners[1]);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 2; k < count; ++k) {
      // Every other corner on the same side of every edge: so a star that goes around twice is none.
      const ExactVec3 &from = corners[i];
      const ExactVec3 edge = corners[(i + 1) % count] - from;
      const ExactVec3 other = corners[(i + k) % count] - from;
      if (dot(normal, other) != 0 || dot(cross(edge, other), normal) <= 0)
        return false;
    }
  return true;
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
