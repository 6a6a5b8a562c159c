#include "tests/lessons/construction/claims/point_at_plane.h"
#include "tests/lessons/construction/claims/said_angle.h"

namespace halfspace::test::claims {

Claims signed_distance() {
  const Claims own = claimsAbout<PointAtPlane>({
      {"{f} is positive: {Q} lies on the side that {n} points to, {distance}.",
       [](const PointAtPlane &at) { return at.f > 0; }},
      {"{f} is negative: {Q} lies on the side that {n} points away from, {distance}.",
       [](const PointAtPlane &at) { return at.f < 0; }},
      {"f({Q}) = 0: {Q} lies in the plane.", [](const PointAtPlane &at) { return at.f == 0 && at.nn != 0; }},
      {"The sign tells the side: positive where {n} points.",
       [](const PointAtPlane &at) { return at.f > 0; }},
      {"The sign tells the side: negative on the side that {n} points away from.",
       [](const PointAtPlane &at) { return at.f < 0; }},
      {"Zero: {Q} satisfies the plane's equation, so it lies in the plane.",
       [](const PointAtPlane &at) { return at.f == 0 && at.nn != 0; }},
      {"signed distance", always}, // in {distance}
      {"Straight across from {Q}, on the line through {P0} along {n}.",
       [](const PointAtPlane &at) { return at.nn != 0; }},
      {"f of M: the same as f of {Q}, because parallel to the plane f stays the same.",
       [](const PointAtPlane &at) { return at.nn != 0; }},
      {"The length of the normal.", always},
      {"θ{degrees}° is the angle between {n} and w = {Q} − {P0}. So dist = |w| cos θ is the part of w that "
       "runs along {n}.",
       [](const PointAtPlane &at, const Said &said) {
         const ExactVec3 w = at.Q - at.E.point;
         return at.nn != 0 && !vanishes(w) && isAngleBetween(at.E.normal, w, said.at("degrees"));
       }},
  });
  return together({pointAtPlaneClaims(), own});
}

} // namespace halfspace::test::claims
