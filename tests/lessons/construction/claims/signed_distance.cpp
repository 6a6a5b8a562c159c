#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/claims/said_angle.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct Distance {
  explicit Distance(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), Q(objectAs<PointObject>(*objects[1])->at),
        f(product(E.normal, Q) - product(E.normal, E.point)), nn(product(E.normal, E.normal)) {}

  PlaneObject E;
  ExactVec3 Q;
  Rational f;
  Rational nn;
};

} // namespace

namespace claims {

Claims signed_distance() {
  return claimsAbout<Distance>({
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const Distance &at) { return at.nn == 0; }},
      {"{f} is positive: {Q} lies on the side that {n} points to, {distance}.",
       [](const Distance &at) { return at.f > 0; }},
      {"{f} is negative: {Q} lies on the side that {n} points away from, {distance}.",
       [](const Distance &at) { return at.f < 0; }},
      {"f({Q}) = 0: {Q} lies in the plane.", [](const Distance &at) { return at.f == 0 && at.nn != 0; }},
      {"Zero, because {n} is the zero vector: there is no plane.",
       [](const Distance &at) { return at.nn == 0; }},
      {"Zero in the plane, positive on the side that {n} points to.",
       [](const Distance &at) { return at.nn != 0; }},
      {"The sign tells the side: positive where {n} points.", [](const Distance &at) { return at.f > 0; }},
      {"The sign tells the side: negative on the side that {n} points away from.",
       [](const Distance &at) { return at.f < 0; }},
      {"Zero: {Q} satisfies the plane's equation, so it lies in the plane.",
       [](const Distance &at) { return at.f == 0 && at.nn != 0; }},
      {"signed distance", always}, // in {distance}
      {"Straight across from {Q}, on the line through {P0} along {n}.",
       [](const Distance &at) { return at.nn != 0; }},
      {"f of M: the same as f of {Q}, because parallel to the plane f stays the same.",
       [](const Distance &at) { return at.nn != 0; }},
      {"The length of the normal.", always},
      {"f({Q}) is 0, and so is the distance: 0 divided by any length is 0.",
       [](const Distance &at) { return at.f == 0 && at.nn != 0; }},
      {"Because |{n}| = 1, f({Q}) is the signed distance already.",
       [](const Distance &at) { return at.nn == 1; }},
      {"{f} is not the distance: {n} is {length} long, so f({Q}) is {length} times the distance.",
       [](const Distance &at) { return at.f != 0 && at.nn != 1; }},
      {"θ{degrees}° is the angle between {n} and w = {Q} − {P0}. So dist = |w| cos θ is the part of w that "
       "runs along {n}.",
       [](const Distance &at, const Said &said) {
         const ExactVec3 w = at.Q - at.E.point;
         return at.nn != 0 && !vanishes(w) && isAngleBetween(at.E.normal, w, said.at("degrees"));
       }},
      {"The foot: from {Q} straight along {n} to the plane, its nearest point.",
       [](const Distance &at) { return at.nn != 0; }},
  });
}

} // namespace claims
} // namespace halfspace::test
