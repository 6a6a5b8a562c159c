#include "lessons/object/point_by_sides.h"

#include "geometry/triangle.h"

#include <algorithm>

namespace halfspace {
namespace {

struct Sides {
  explicit Sides(const Object &triangle) : u(triangle[1] - triangle[0]), v(triangle[2] - triangle[0]) {}
  ExactVec3 u;
  ExactVec3 v;
};

} // namespace

std::vector<CoordinateSpec> sideSteps() {
  return {{"s", CoordinateRole::Number}, {"t", CoordinateRole::Number}};
}

std::optional<ExactVec3> placeBySides(const Object &bound, const Object &host) {
  return pointOf(Triangle<Rational>{host[0], host[1], host[2]}, bound[StepsOfU].x, bound[StepsOfV].x);
}

std::optional<Object> nearestBySides(Object bound, const Object &host, const ExactVec3 &place) {
  const auto [u, v] = Sides(host);
  const ExactVec3 w = place - host[0];
  const Rational determinant = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
  if (determinant == 0)
    return {};
  bound[StepsOfU].x = (dot(w, u) * dot(v, v) - dot(w, v) * dot(u, v)) / determinant;
  bound[StepsOfV].x = (dot(w, v) * dot(u, u) - dot(w, u) * dot(u, v)) / determinant;
  return bound;
}

Object bySidesOnGrid(Object bound, const Object &host, const Rational &step) {
  const auto [u, v] = Sides(host);
  const Rational coarse = freedomStep(step, std::max(dot(u, u), dot(v, v)));
  bound[StepsOfU].x = roundToMultiple(bound[StepsOfU].x, coarse);
  bound[StepsOfV].x = roundToMultiple(bound[StepsOfV].x, coarse);
  return bound;
}

void guideBySides(const Object &host, Handle &handle) {
  handle.normal = normalOfCorners(host);
  if (handle.normal == ExactVec3(0)) // no more than a line
    handle.axis = isZero(host[1] - host[0]) ? host[2] - host[0] : host[1] - host[0];
}

} // namespace halfspace
