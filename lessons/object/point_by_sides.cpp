#include "lessons/object/point_by_sides.h"

#include "lessons/object/kinds/triangle.h"

#include <algorithm>

namespace halfspace {
namespace {

Object onGrid(Object bound, const Object &triangle, const Rational &step) {
  const auto [u, v] = TriangleSides(triangle);
  const Rational coarse = freedomStep(step, std::max(dot(u, u), dot(v, v)));
  bound[S].x = roundToMultiple(bound[S].x, coarse);
  bound[T].x = roundToMultiple(bound[T].x, coarse);
  return bound;
}

void guide(const Object &triangle, Handle &handle) {
  handle.normal = normalOfCorners(triangle);
  if (handle.normal == ExactVec3(0)) { // no more than a line
    const auto [u, v] = TriangleSides(triangle);
    handle.axis = isZero(u) ? v : u;
  }
}

} // namespace

std::optional<ExactVec3> placeBySides(const Object &bound, const Object &triangle) {
  const auto [u, v] = TriangleSides(triangle);
  return triangle[0] + u * bound[S].x + v * bound[T].x;
}

std::optional<Object> footBySides(Object bound, const Object &triangle, const ExactVec3 &place) {
  const auto [u, v] = TriangleSides(triangle);
  const ExactVec3 w = place - triangle[0];
  const Rational determinant = dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v);
  if (determinant == 0)
    return {};
  bound[S].x = (dot(w, u) * dot(v, v) - dot(w, v) * dot(u, v)) / determinant;
  bound[T].x = (dot(w, v) * dot(u, u) - dot(w, u) * dot(u, v)) / determinant;
  return bound;
}

Kind pointBySides(std::string_view word, std::string (*noun)(), std::string_view meaning,
                  void (*settle)(Object &),
                  Object (*nearest)(Object bound, const Object &triangle, const ExactVec3 &place)) {
  return boundPoint(word, noun, meaning, {{"s", CoordinateRole::Number}, {"t", CoordinateRole::Number}},
                    settle,
                    {.host = TriangleObject::kind,
                     .placeOf = placeBySides,
                     .nearest = nearest,
                     .onGrid = onGrid,
                     .guide = guide});
}

} // namespace halfspace
