#include "tests/lessons/construction/claims/triangle_words.h"

namespace halfspace::test::claims {
namespace {

bool isProper(const TriangleCorners &at) { return at.isTriangle(); }

} // namespace

Claims triangle_area() {
  return together(
      {crossProductClaims(),
       coincidenceClaims("{first} and {second} are the same point: no area is left.",
                         "{first}, {second} and {third} are the same point: no area is left."),
       claimsAbout<TriangleCorners>({
           {"The triangle is half of the parallelogram of u and v. Its area is {A}.", isProper},
           {"{P0}, {P1} and {P2} lie on one line: no area is left.",
            [](const TriangleCorners &at) { return at.isCollinear(); }},
           {"Two sides of the triangle, both from {P0}.", always},
           {"Half of the parallelogram of u and v, whose area is |n|.", isProper},
           {"0: u and v span no parallelogram.", [](const TriangleCorners &at) { return !at.isTriangle(); }},
           {"The height over u: the area of the parallelogram divided by its base.", isProper},
           {"Half of base times height: the same area.", isProper},
       })});
}

} // namespace halfspace::test::claims
