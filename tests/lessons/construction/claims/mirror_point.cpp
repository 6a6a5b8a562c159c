#include "tests/lessons/construction/claims/point_at_plane.h"

namespace halfspace::test {
namespace {

bool isInPlane(const PointAtPlane &at) { return at.f == 0 && at.nn != 0; }

} // namespace

namespace claims {

Claims mirror_point() {
  const Claims own = claimsAbout<PointAtPlane>({
      {"{Q} lies on the side that {n} points to, and its mirror image {S} lies as far from the plane on the "
       "other side.",
       [](const PointAtPlane &at) { return at.f > 0; }},
      {"{Q} lies on the side that {n} points away from, and its mirror image {S} lies as far from the plane "
       "on the other side.",
       [](const PointAtPlane &at) { return at.f < 0; }},
      {"{Q} lies in the plane, and is its own mirror image.", isInPlane},
      {"The mirror image is {Q} itself: f({Q}) is 0.", isInPlane},
      {"The mirror image: from {Q} through the foot, and as far again.",
       [](const PointAtPlane &at) { return at.f != 0; }},
      {"The foot once more: it is the midpoint of {Q} and {S}.",
       [](const PointAtPlane &at) { return at.nn != 0; }},
  });
  return together({pointAtPlaneClaims(), own});
}

} // namespace claims
} // namespace halfspace::test
