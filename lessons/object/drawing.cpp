#include "lessons/object/drawing.h"

#include "lessons/object/letters.h"
#include "lessons/term/among_words.h"
#include "lessons/term/latex.h"
#include "lessons/term/rewrite.h"
#include "lessons/term/written.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace halfspace {
namespace {

/// The numbers behind a letter, with what stands between them where none is rounded.
std::string writtenBehind(const std::string &relation, const Term &term) {
  const Term numbers = amongWords(calculated(term));
  return (showsRounded(numbers) ? "\\approx " : relation) + "{" + latexOf(numbers, Fractions::Flat) + "}";
}

} // namespace

Place place(const Term &term) {
  const std::vector<Polynomial> &entries = term->value.value().entries;
  return {toDouble(entries.at(0).constant()), toDouble(entries.at(1).constant()),
          toDouble(entries.at(2).constant())};
}

MarkBase drawn(const Term &letter, Role role, Subject subject) {
  return {letter->mark, role, subject, latexOf(letter)};
}

// A group of its own stands close to the letter, as an argument does.
std::string writtenCoordinates(const Term &point) { return writtenBehind("", point); }

std::string writtenVector(const Term &vector) { return writtenBehind("= ", vector); }

PointMark pointOf(const Term &letter, Role role, Subject subject) {
  MarkBase base = drawn(letter, role, subject);
  base.coordinates = writtenCoordinates(letter);
  return {std::move(base), place(letter)};
}

ArrowMark arrowOf(const Term &letter, const Place &from, Role role, Subject subject) {
  return {drawn(letter, role, subject), from, place(letter)};
}

ExactVec3 areaOf(const std::vector<ExactVec3> &corners) {
  ExactVec3 area(0);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    area += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
  return area;
}

bool isFlatAndConvex(const std::vector<ExactVec3> &corners) {
  const std::size_t count = corners.size();
  const ExactVec3 area = areaOf(corners);
  if (isZero(area))
    return false;
  for (std::size_t i = 0; i < count; ++i) {
    const ExactVec3 edge = corners[(i + 1) % count] - corners[i];
    if (isZero(edge))
      return false;
    for (std::size_t k = 2; k < count; ++k) {
      // Every other corner on the same side of every edge: so a star that goes around twice is none.
      const ExactVec3 other = corners[(i + k) % count] - corners[i];
      if (dot(area, other) != 0 || dot(cross(edge, other), area) < 0)
        return false;
    }
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

ArrowMark arrowInPicture(MarkBase base, const Place &from, const Place &unit, double length) {
  return {std::move(base), from, unit, false, length};
}

void addDirection(Figure &figure, const Term &vector, const Place &from, double length, Role role,
                  Subject subject) {
  if (const ExactVec3 direction = vectorOf(vector); !isZero(direction))
    figure.add(arrowOfLength(drawn(vector, role, subject), from, direction, length));
}

} // namespace halfspace
