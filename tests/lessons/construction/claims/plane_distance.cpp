#include "tests/lessons/construction/claims/two_planes.h"

namespace halfspace::test::claims {

Claims plane_distance() {
  const Claims own = claimsAbout<TwoPlanes>({
      {"{E} and {F} are not parallel: they meet, and their distance is 0.", meetInLine},
      {"{E} and {F} are parallel, and everywhere equally far from each other: {distance}.", areParallel},
      {"distance", areParallel}, // in {distance}
      {"{E} and {F} are the same plane: their distance is 0.", areSame},
      {"The zero vector: the normals lie along one line, so the planes are parallel or the same.",
       [](const TwoPlanes &at) { return at.haveSameNormals(); }},
      {"Not the zero vector: the normals do not lie along one line, so the planes meet.", meetInLine},
      {"From {E.P0} to {F.P0}.", always},
      {"Not 0: {F.P0} does not lie in {E}, so the planes do not meet.", areParallel},
      {"0: {F.P0} lies in {E}, so the planes are the same.", areSame},
      {"How far w reaches along {E.n}, without a sign: the distance of the planes.", areParallel},
      {"0: the planes are the same.", areSame},
  });
  return together({zeroNormalsClaims(), own});
}

} // namespace halfspace::test::claims
