// A line and a plane, as several constructions look at them.
#pragma once

#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {

struct LineAtPlane {
  explicit LineAtPlane(Objects objects)
      : g(objectAs<LineObject>(*objects[0]).value()), E(objectAs<PlaneObject>(*objects[1]).value()),
        vn(product(g.direction, E.normal)) {}

  bool isLine() const { return !vanishes(g.direction); }
  bool isPlane() const { return !vanishes(E.normal); }
  bool isAlong() const { return isLine() && isPlane() && vn == 0; }
  bool isPointInPlane() const { return product(E.normal, ExactVec3(g.point - E.point)) == 0; }

  LineObject g;
  PlaneObject E;
  Rational vn;
};

} // namespace halfspace::test
