#include "lessons/drawing.h"

#include "lessons/given.h"
#include "lessons/term/latex.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>

namespace halfspace {

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
    figure.marks.push_back(PlanePatchMark{
        {"E", Role::Given, Subject::Plane, "E", "\\colon\\ {" + latexOf(equationOf(plane)) + "}"},
        point,
        place(plane.normal),
        covers});
    figure.marks.push_back(
        ArrowMark{{"n", Role::Given, Subject::Plane, "\\vec n"}, point, place(plane.normal), true});
  }
  figure.marks.push_back(PointMark{{"P0", Role::Given, Subject::Plane, "P_0"}, point});
}

void drawRay(Figure &figure, const RayObject &ray, const std::optional<Place> &meets) {
  const Place origin = place(ray.origin);
  const Place direction = place(ray.direction);
  if (!isZero(ray.direction)) {
    figure.marks.push_back(
        RayMark{{"ray", Role::Given, Subject::Ray, ""}, origin, unitOf(ray.direction), meets});
    figure.marks.push_back(ArrowMark{{"r", Role::Given, Subject::Ray, "\\vec r"}, origin, direction, true});
  }
  figure.marks.push_back(PointMark{{"Q", Role::Given, Subject::Point, "Q"}, origin});
}

void drawCorners(Figure &figure, const TriangleObject &triangle) {
  const std::array<const ExactVec3 *, 3> corners{&triangle.p0, &triangle.p1, &triangle.p2};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::string index = std::to_string(i);
    figure.marks.push_back(
        PointMark{{"P" + index, Role::Given, Subject::Triangle, "P_" + index}, place(*corners[i])});
  }
}

} // namespace halfspace
