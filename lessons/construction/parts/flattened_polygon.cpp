#include "lessons/construction/parts/flattened_polygon.h"

#include "geometry/polygon.h"

namespace halfspace {

PolygonObject flattenedPolygon(PolygonObject polygon) {
  const Plane<Rational> plane = planeOf<Rational>(weighted(polygon.corners));
  for (ExactVec3 &corner : polygon.corners)
    corner -= plane.normal * Rational(evaluate(plane, corner) / dot(plane.normal, plane.normal));
  return polygon;
}

} // namespace halfspace
