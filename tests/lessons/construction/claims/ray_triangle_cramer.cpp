#include "tests/lessons/construction/claims/ray_at_triangle.h"

namespace halfspace::test {
namespace {

bool crosses(const RayAtTriangle &at) { return at.crosses(); }
bool isBehind(const RayAtTriangle &at) { return at.isBehind(); }

/// The determinant |a b c| of the sides that lead to P₀ and the way from the start to it.
Rational lastDeterminant(const RayAtTriangle &at) {
  return determinant(ExactVec3(-at.u), ExactVec3(-at.v), ExactVec3(at.corners[0] - at.L.origin));
}

/// |a b r| or |c b r|, for the arrow that the sentence names: it has the sign of that arrow's height on the
/// face of b and r.
Rational heightNamed(const RayAtTriangle &at, const Said &said) {
  const ExactVec3 first =
      said.at("vector") == "a" ? ExactVec3(-at.u) : ExactVec3(at.corners[0] - at.L.origin);
  return determinant(first, ExactVec3(-at.v), at.L.direction);
}

} // namespace

namespace claims {

Claims ray_triangle_cramer() {
  const Claims own = claimsAbout<RayAtTriangle>({
      {"The line meets the triangle's plane outside the triangle: {sigma}, {tau}, {sum}.",
       [](const RayAtTriangle &at) { return at.misses(); }},
      {"D = 0, but not D₃: the ray runs parallel to the triangle's plane and never meets it.",
       [](const RayAtTriangle &at) { return at.isParallel() && lastDeterminant(at) != 0; }},
      {"D = 0 and D₃ = 0: the ray lies in the triangle's plane, and no single point is the hit.",
       [](const RayAtTriangle &at) { return at.isInPlane() && lastDeterminant(at) == 0; }},
      {"{P0}, {P1} and {P2} lie on one line: two columns are multiples of each other, and D is 0.",
       [](const RayAtTriangle &at) { return at.isCollinear(); }},
      {"From {P1} to {P0}.", always},
      {"From {P2} to {P0}.", always},
      {"From {Q} to {P0}.", always},
      {"By its first column: each number of a times what is left without its row and column. Signs: plus, "
       "minus, plus.",
       always},
      {"The first cross product that is used twice.", always},
      {"The second cross product that is used twice.", always},
      {"Zero: there is nothing to divide by, so no single point is the answer.",
       [](const RayAtTriangle &at) { return !at.crosses(); }},
      {"The small determinants are the coordinates of p, with the signs already in them.", crosses},
      {"c in the place of a: p is there already.", always},
      {"c in the place of b. Here the last column is split off: {r}.", always},
      {"c in the place of {r}. The middle column is split off, and that one comes with a minus.", always},
      {"The weight of {P1}.", crosses},
      {"The weight of {P2}.", crosses},
      {"These are the weights of {P0}, {P1} and {P2}. The line of the ray meets the plane outside the "
       "triangle.",
       [](const RayAtTriangle &at) { return at.misses(); }},
      {"Negative: the line gets there before the ray's start {Q}, so the ray does not hit.",
       [](const RayAtTriangle &at) { return at.crosses() && at.lambda() < 0; }},
      {"Not negative: the ray itself gets there.",
       [](const RayAtTriangle &at) { return at.crosses() && at.lambda() >= 0; }},
      {"How far {vector} reaches along p: the height of its box on the face of b and {r}.",
       [](const RayAtTriangle &at, const Said &said) { return at.crosses() && heightNamed(at, said) > 0; }},
      {"How far {vector} reaches along p. Negative: it points to one side of the face of b and {r}, and p to "
       "the other.",
       [](const RayAtTriangle &at, const Said &said) { return at.crosses() && heightNamed(at, said) < 0; }},
      {"0: {vector} lies in the plane of b and {r}, and its box is flat.",
       [](const RayAtTriangle &at, const Said &said) { return at.crosses() && heightNamed(at, said) == 0; }},
      {"Both boxes stand on the face of b and {r}. So their volumes compare as their heights do.", crosses},
      {"Where the line of the ray meets the triangle's plane.", crosses},
  });
  return together(
      {own, hitClaims(),
       placeClaims(isBehind,
                   "{lambda} is negative: the triangle is behind the ray's start. Only the line backwards "
                   "meets it, inside the triangle.",
                   "{lambda} is negative: the triangle is behind the ray's start. Only the line backwards "
                   "meets it, on the edge {edge}.",
                   "{lambda} is negative: the triangle is behind the ray's start. Only the line backwards "
                   "meets it, at the corner {corner}."),
       placeClaims(crosses,
                   "These are the weights of {P0}, {P1} and {P2}. The line of the ray meets the plane inside "
                   "the triangle.",
                   "These are the weights of {P0}, {P1} and {P2}. The line of the ray meets the plane on the "
                   "edge {edge}.",
                   "These are the weights of {P0}, {P1} and {P2}. The line of the ray meets the plane at the "
                   "corner {corner}."),
       coincidenceClaims(
           "{first} and {second} are the same point: this is no triangle, and D is 0.",
           "{first}, {second} and {third} are the same point: this is no triangle, and D is 0."),
       zeroDirectionClaims(1)});
}

} // namespace claims
} // namespace halfspace::test
