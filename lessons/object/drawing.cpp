#include "lessons/object/drawing.h"

#include "lessons/object/letters.h"
#include "lessons/term/latex.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

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

void drawPlane(Figure &figure, const PlaneObject &plane, const std::vector<Place> &covers) {
  const Place point = place(plane.point);
  if (!isZero(plane.normal)) {
    figure.add(PlanePatchMark{
        {"E", Role::Given, Subject::Plane, "E", "\\colon\\ {" + latexOf(equationOf(plane)) + "}"},
        point,
        place(plane.normal),
        covers});
    figure.add(ArrowMark{{"n", Role::Given, Subject::Plane, "\\vec n"}, point, place(plane.normal), true});
  }
  figure.add(PointMark{{"P0", Role::Given, Subject::Plane, "P_0"}, point});
}

void drawRay(Figure &figure, const RayObject &ray, const std::optional<Place> &meets) {
  const Place origin = place(ray.origin);
  const Place direction = place(ray.direction);
  if (!isZero(ray.direction)) {
    figure.add(RayMark{{"ray", Role::Given, Subject::Ray}, origin, unitOf(ray.direction), meets});
    figure.add(ArrowMark{{"r", Role::Given, Subject::Ray, "\\vec r"}, origin, direction, true});
  }
  figure.add(PointMark{{"Q", Role::Given, Subject::Point, "Q"}, origin});
}

void drawCorners(Figure &figure, const TriangleObject &triangle) {
  const std::array<const ExactVec3 *, 3> corners{&triangle.p0, &triangle.p1, &triangle.p2};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::string index = std::to_string(i);
    figure.add(PointMark{{"P" + index, Role::Given, Subject::Triangle, "P_" + index}, place(*corners[i])});
  }
}

} // namespace halfspace
