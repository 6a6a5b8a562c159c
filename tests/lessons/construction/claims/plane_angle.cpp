#include "tests/lessons/construction/claims/two_planes.h"

namespace halfspace::test {
namespace {

/// Whether the angle is told that is at most 90°, as far as it is written.
bool isAngleOfPlanes(const TwoPlanes &at, const Said &said) {
  const ExactVec3 second = at.nn < 0 ? ExactVec3(-at.F.normal) : at.F.normal;
  return at.arePlanes() && isAngleBetween(at.E.normal, second, said.at("degrees"));
}

} // namespace

namespace claims {

Claims plane_angle() {
  const Claims own = claimsAbout<TwoPlanes>({
      {"{E} and {F} are the same plane: the angle is 0°.", areSame},
      {"{E} and {F} are parallel: the angle is 0°.", areParallel},
      {"{E.n}·{F.n} = 0: {E} and {F} stand at a right angle to each other.",
       [](const TwoPlanes &at) { return at.arePlanes() && at.nn == 0; }},
      {"The planes {E} and {F} meet at the angle φ{degrees}°, and on the other side at 180° − φ.",
       [](const TwoPlanes &at, const Said &said) {
         return at.meetInLine() && at.nn != 0 && isAngleOfPlanes(at, said);
       }},
      {"Positive: the normals are less than 90° apart.", [](const TwoPlanes &at) { return at.nn > 0; }},
      {"Negative: the normals are more than 90° apart. The angle of the planes is at most 90°, so the sign "
       "will be left out.",
       [](const TwoPlanes &at) { return at.nn < 0; }},
      {"Zero: the normals are perpendicular to each other, and so are the planes.",
       [](const TwoPlanes &at) { return at.arePlanes() && at.nn == 0; }},
      {"The length of {vector}.", arePlanes},
      {"φ{degrees}°: the angle of the planes. The normals are 180° − φ apart.",
       [](const TwoPlanes &at, const Said &said) { return at.nn < 0 && isAngleOfPlanes(at, said); }},
      {"φ{degrees}°: the angle of the planes, and of the normals.",
       [](const TwoPlanes &at, const Said &said) { return at.nn >= 0 && isAngleOfPlanes(at, said); }},
  });
  return together({zeroNormalsClaims(), own});
}

} // namespace claims
} // namespace halfspace::test
