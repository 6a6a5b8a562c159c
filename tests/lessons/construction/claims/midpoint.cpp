#include "tests/lessons/construction/claims/two_points.h"

namespace halfspace::test::claims {

Claims midpoint() {
  const Claims own = claimsAbout<PointPair>({
      {"{M} is in the middle between {A} and {B}, equally far from both.", areApart},
      {"{A} and {B} are the same point, and so is {M}.", areSame},
      {"The midpoint: each coordinate is the mean of those of {A} and {B}.", always},
      {"The same point: half of the way from {A} to {B}.", always},
  });
  return together({wayClaims(), own});
}

} // namespace halfspace::test::claims
