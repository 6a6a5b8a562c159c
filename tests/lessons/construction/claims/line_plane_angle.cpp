#include "tests/lessons/construction/claims/line_at_plane.h"
#include "tests/lessons/construction/claims/said_angle.h"

namespace halfspace::test {
namespace {

bool areBoth(const LineAtPlane &at) { return at.isLine() && at.isPlane(); }

/// n·n times what is left of the direction in the plane.
ExactVec3 shadowOf(const LineAtPlane &at) {
  return perpendicular(at.E.normal, perpendicular(at.g.direction, at.E.normal));
}

/// Whether the angle between the line and its shadow is told, as far as it is written.
bool isAngleToShadow(const LineAtPlane &at, const Said &said) {
  if (!areBoth(at))
    return false;
  const ExactVec3 shadow = shadowOf(at);
  if (!vanishes(shadow))
    return isAngleBetween(at.g.direction, shadow, said.at("degrees"));
  return said.at("degrees") == " = 90";
}

} // namespace

namespace claims {

Claims line_plane_angle() {
  return claimsAbout<LineAtPlane>({
      {"{g} lies in {E}: the angle is 0°.",
       [](const LineAtPlane &at) { return at.isAlong() && at.isPointInPlane(); }},
      {"{g} is parallel to {E}: the angle is 0°.",
       [](const LineAtPlane &at) { return at.isAlong() && !at.isPointInPlane(); }},
      {"{v} is a multiple of {n}: {g} meets {E} at a right angle.",
       [](const LineAtPlane &at) { return areBoth(at) && vanishes(shadowOf(at)); }},
      {"{g} meets {E} at the angle α{degrees}°.",
       [](const LineAtPlane &at, const Said &said) {
         return at.vn != 0 && !vanishes(shadowOf(at)) && isAngleToShadow(at, said);
       }},
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const LineAtPlane &at) { return !at.isPlane(); }},
      {"The direction {v} is the zero vector: it points nowhere, so there is no line.",
       [](const LineAtPlane &at) { return !at.isLine(); }},
      {"Zero: {v} is perpendicular to {n}, so it runs along the plane.",
       [](const LineAtPlane &at) { return at.isAlong(); }},
      {"Not 0: {v} leads out of the plane. On which side does not matter to the angle.",
       [](const LineAtPlane &at) { return at.vn != 0; }},
      {"The length of {vector}.", areBoth},
      {"α{degrees}°: the angle between {g} and {E}. With {n} the line has the angle 90° − α, whose cosine "
       "this is.",
       isAngleToShadow},
  });
}

} // namespace claims
} // namespace halfspace::test
