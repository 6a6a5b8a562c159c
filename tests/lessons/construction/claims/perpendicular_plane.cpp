#include "tests/lessons/construction/claims/line_and_point.h"

namespace halfspace::test::claims {

Claims perpendicular_plane() {
  return together(
      {zeroLineClaims(),
       claimsAbout<LineAndPoint>({
           {"{E} goes through {Q} and is perpendicular to {g}, which it meets in {point}.", isBeside},
           {"{Q} lies on {g}: {E} is perpendicular to the line and meets it in {Q}.", isOnLine},
           {"The direction of the line is a normal of the plane.", isLine},
           {"So that {Q} fulfils the equation.", isLine},
           {"A point P = (x, y, z) lies in {plane} exactly when it makes this 0.", isLine},
           {"{A} + t {v} put into the equation and solved for t: this many steps lead from {A} to "
            "the plane.",
            isLine},
           {"Where {g} meets {E}. It is the point of the line that is nearest to {Q}.", isLine},
       })});
}

} // namespace halfspace::test::claims
