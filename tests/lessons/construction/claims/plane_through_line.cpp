#include "tests/lessons/construction/claims/line_and_point.h"

namespace halfspace::test::claims {

Claims plane_through_line() {
  return together(
      {zeroLineClaims(),
       claimsAbout<LineAndPoint>({
           {"{E} is the only plane that contains the line {g} and the point {Q}: {equation}.", isBeside},
           {"{Q} lies on the line {g}: every plane that contains the line contains {Q}, so none is special.",
            isOnLine},
           {"From {A} to {Q}.", always},
           {"{v} and w lie in the plane, so this is perpendicular to it.", isBeside},
           {"The zero vector: {v} and w lie along one line and span no plane.", isOnLine},
           {"So that {A} fulfils the equation.", isBeside},
           {"0: {Q} fulfils the equation too, as every point of the line does.", isBeside},
           {"A point P = (x, y, z) lies in {plane} exactly when it makes this 0.", isBeside},
           {"How far {Q} is from the line: the area of the parallelogram of {v} and w by the length of its "
            "side {v}.",
            isBeside},
       })});
}

} // namespace halfspace::test::claims
