#include "tests/lessons/construction/claims/ray_at_plane.h"

namespace halfspace::test {
namespace {

bool isProper(const RayAtPlane &at) { return at.isRay() && at.isPlane(); }
bool hits(const RayAtPlane &at) { return at.crosses() && at.t() >= 0; }
bool isStraight(const RayAtPlane &at) {
  return hits(at) && vanishes(perpendicular(at.E.normal, at.L.direction));
}
bool isBehind(const RayAtPlane &at) { return at.crosses() && at.t() < 0; }
bool runsAlong(const RayAtPlane &at) { return isProper(at) && at.rn == 0; }

} // namespace

namespace claims {

Claims mirror_ray() {
  return claimsAbout<RayAtPlane>({
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const RayAtPlane &at) { return !at.isPlane(); }},
      {"The direction {r} is the zero vector: the ray goes nowhere.",
       [](const RayAtPlane &at) { return !at.isRay(); }},
      {"{L} hits the mirror at a right angle: the ray {R} runs straight back.", isStraight},
      {"{L} hits the mirror in {R.Q}, and goes on from there as the ray {R}.",
       [](const RayAtPlane &at) { return hits(at) && !isStraight(at); }},
      {"{t} is negative: {L} points away from the mirror, and nothing is sent on.", isBehind},
      {"{r}·{n} = 0: {L} runs parallel to the mirror, and nothing is sent on.",
       [](const RayAtPlane &at) { return runsAlong(at) && at.height != 0; }},
      {"{r}·{n} = 0 and {Q} is in the mirror: {L} runs along in it, and nothing is sent on.",
       [](const RayAtPlane &at) { return runsAlong(at) && at.height == 0; }},
      {"Not 0: the line of {L} meets the mirror once.", [](const RayAtPlane &at) { return at.crosses(); }},
      {"0: {r} runs along the mirror, and never comes nearer to it.", runsAlong},
      {"So many steps {r} lead from {Q} to the mirror.", hits},
      {"Negative: the mirror is behind {Q}.", isBehind},
      {"{Q} itself: the ray starts in the mirror.",
       [](const RayAtPlane &at) { return hits(at) && at.height == 0; }},
      {"Where {L} hits the mirror, {R} starts.",
       [](const RayAtPlane &at) { return hits(at) && at.height != 0; }},
      {"{r} runs along {n}, and is turned round as a whole.", isStraight},
      {"The part of {r} along {n} turns round, and the part across {n} stays.",
       [](const RayAtPlane &at) { return hits(at) && !isStraight(at); }},
      {"The same number: both are equally long.",
       [](const RayAtPlane &at) {
         const Rational nn = product(at.E.normal, at.E.normal);
         const ExactVec3 turned = at.L.direction * nn - at.E.normal * Rational(2 * at.rn);
         return product(turned, turned) == product(at.L.direction, at.L.direction) * nn * nn;
       }},
  });
}

} // namespace claims
} // namespace halfspace::test
