#include "tests/lessons/construction/claims/two_points.h"

namespace halfspace::test::claims {

Claims point_point() {
  const Claims own = claimsAbout<PointPair>({
      {"{A} and {B} are different points: {distance}.", areApart},
      {"distance", always}, // in {distance}
      {"{A} and {B} are the same point: their distance is 0.", areSame},
      {"The square of the distance: the sum of the squares of the three coordinates.", always},
      {"The distance is the length of this arrow.", areApart},
      {"0: the way has no length.", areSame},
  });
  return together({wayClaims(), own});
}

} // namespace halfspace::test::claims
