#include "tests/lessons/construction/claims/two_planes.h"

namespace halfspace::test::claims {

Claims plane_plane() {
  const Claims own = claimsAbout<TwoPlanes>({
      {"The planes {E} and {F} meet in the line {g}.", meetInLine},
      {"The normals are multiples of each other, and no point lies in both planes: {E} and {F} are parallel.",
       areParallel},
      {"{E} and {F} are the same plane: every point of one lies in the other.", areSame},
      {"The constant d of {plane}: its equation is n·P + d = 0.", arePlanes},
      {"The line lies in both planes, so it is perpendicular to both normals.", meetInLine},
      {"The cross product is the zero vector: the normals lie along the same line, and the planes share no "
       "single line.",
       [](const TwoPlanes &at) { return at.haveSameNormals(); }},
      {"The moment P × {v} is the same for every point P of the line. The two equations give it without "
       "knowing any point.",
       meetInLine},
      {"The moment is zero: the line goes through the origin, which is its nearest point.",
       [](const TwoPlanes &at) { return at.meetInLine() && at.passThroughOrigin(); }},
      {"The point of the line that is nearest to the origin.", meetInLine},
      {"φ{degrees}°: the normals lie along the same line.",
       [](const TwoPlanes &at, const Said &said) {
         return at.haveSameNormals() && at.isAngle(said.at("degrees"));
       }},
      {"φ{degrees}° is the angle between the normals, and so between the planes.",
       [](const TwoPlanes &at, const Said &said) {
         return at.meetInLine() && at.nn >= 0 && at.isAngle(said.at("degrees"));
       }},
      {"φ{degrees}° is the angle between the normals. The planes meet at 180° − φ.",
       [](const TwoPlanes &at, const Said &said) {
         return at.meetInLine() && at.nn < 0 && at.isAngle(said.at("degrees"));
       }},
  });
  return together({zeroNormalsClaims(), own});
}

} // namespace halfspace::test::claims
