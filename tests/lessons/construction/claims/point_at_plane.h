// A point and a plane, as several constructions look at them and what they say of f and the distance.
#pragma once

#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {

struct PointAtPlane {
  explicit PointAtPlane(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), Q(objectAs<PointObject>(*objects[1])->at),
        f(product(E.normal, Q) - product(E.normal, E.point)), nn(product(E.normal, E.normal)) {}

  PlaneObject E;
  ExactVec3 Q;
  Rational f;
  Rational nn;
};

/// Of the plane's equation, the signed distance and the foot.
[[nodiscard]] inline Claims pointAtPlaneClaims() {
  return claimsAbout<PointAtPlane>({
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const PointAtPlane &at) { return at.nn == 0; }},
      {"Zero, because {n} is the zero vector: there is no plane.",
       [](const PointAtPlane &at) { return at.nn == 0; }},
      {"Zero in the plane, positive on the side that {n} points to.",
       [](const PointAtPlane &at) { return at.nn != 0; }},
      {"f({Q}) is 0, and so is the distance: 0 divided by any length is 0.",
       [](const PointAtPlane &at) { return at.f == 0 && at.nn != 0; }},
      {"Because |{n}| = 1, f({Q}) is the signed distance already.",
       [](const PointAtPlane &at) { return at.nn == 1; }},
      {"{f} is not the distance: {n} is {length} long, so f({Q}) is {length} times the distance.",
       [](const PointAtPlane &at) { return at.f != 0 && at.nn != 1; }},
      {"The foot: from {Q} straight along {n} to the plane, its nearest point.",
       [](const PointAtPlane &at) { return at.nn != 0; }},
  });
}

} // namespace halfspace::test
