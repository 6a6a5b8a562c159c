// A plane and a ray, as several constructions look at them.
#pragma once

#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {

struct RayAtPlane {
  /// A plane, the first object, and a ray, the second.
  explicit RayAtPlane(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), L(objectAs<RayObject>(*objects[1]).value()),
        rn(product(L.direction, E.normal)), height(product(E.normal, L.origin) - product(E.normal, E.point)) {
  }

  bool isRay() const { return !vanishes(L.direction); }
  bool isPlane() const { return !vanishes(E.normal); }
  /// The line's one point in the plane.
  bool crosses() const { return rn != 0; }
  Rational t() const { return -height / rn; }

  PlaneObject E;
  RayObject L;
  Rational rn;     ///< what a step gains along n
  Rational height; ///< of the start over the plane, times |n|
};

} // namespace halfspace::test
