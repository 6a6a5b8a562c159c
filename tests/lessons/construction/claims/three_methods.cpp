#include "tests/lessons/construction/claims/ray_at_triangle.h"

namespace halfspace::test {
namespace {

bool isProper(const RayAtTriangle &at) { return at.isTriangle(); }
bool isFlat(const RayAtTriangle &at) { return !at.isTriangle(); }
bool crosses(const RayAtTriangle &at) { return at.crosses(); }
bool hits(const RayAtTriangle &at) { return at.hits(); }
bool isBehind(const RayAtTriangle &at) { return at.isBehind(); }

/// Whether the ray's line and all corners lie in one plane: then the planes of the line and a corner are one.
bool isCoplanar(const RayAtTriangle &at) {
  std::array<ExactVec3, 3> normals;
  for (std::size_t i = 0; i < 3; ++i)
    normals.at(i) = perpendicular(at.L.direction, ExactVec3(at.corners.at(i) - at.L.origin));
  return at.isRay() && vanishes(perpendicular(normals[0], normals[1])) &&
         vanishes(perpendicular(normals[0], normals[2])) && vanishes(perpendicular(normals[1], normals[2]));
}

/// Counted by hand, from the formulas on paper: multiplications for a triangle and for each ray, additions,
/// divisions.
bool isCountOf(const Said &said) {
  static const std::map<std::string, std::array<int, 4>> counts{
      {"perp-count", {17, 19, 35, 3}}, {"cramer-count", {0, 24, 23, 3}}, {"pluecker-count", {18, 39, 53, 3}}};
  const std::array<int, 4> &count = counts.at(said.line);
  return said.at("once") == std::to_string(count[0]) && said.at("ray") == std::to_string(count[1]) &&
         said.at("additions") == std::to_string(count[2]) && said.at("divisions") == std::to_string(count[3]);
}

Claims caseClaims() {
  return claimsAbout<RayAtTriangle>({
      {"All three ways find the same point, and it is outside the triangle: {s}, {t}, {sum}.",
       [](const RayAtTriangle &at) { return at.misses(); }},
      {"{r}·n, D and S are 0: the ray runs parallel to the triangle's plane. Two ways have nothing to divide "
       "by; the signs of the products say that it passes outside.",
       [](const RayAtTriangle &at) { return at.isParallel(); }},
      {"{r}·n, D and all three products are 0: the ray lies in the triangle's plane, and none of the three "
       "ways has a single point to give.",
       [](const RayAtTriangle &at) { return at.isInPlane() && isCoplanar(at); }},
      {"{P0}, {P1} and {P2} lie on one line: G, D and S are 0, whatever the ray does.",
       [](const RayAtTriangle &at) { return at.isCollinear(); }},
  });
}

Claims crossingClaims() {
  return together(
      {placeClaims(hits, "All three ways lead to the same hit: inside the triangle, at {lambda}.",
                   "All three ways lead to the same hit: on the edge {edge}, at {lambda}.",
                   "All three ways lead to the same hit: at the corner {corner}, at {lambda}."),
       placeClaims(isBehind,
                   "The line of the ray goes through the inside of the triangle. But {lambda} is "
                   "negative: that is behind the ray's start. The Plücker products cannot see it.",
                   "The line of the ray goes through the edge {edge} of the triangle. But {lambda} is "
                   "negative: that is behind the ray's start. The Plücker products cannot see it.",
                   "The line of the ray goes through the corner {corner} of the triangle. But {lambda} is "
                   "negative: that is behind the ray's start. The Plücker products cannot see it."),
       coincidenceClaims("{first} and {second} are the same point: this is no triangle. G, D and S are 0, "
                         "whatever the ray does.",
                         "{first}, {second} and {third} are the same point: this is no triangle. G, D and S "
                         "are 0, whatever the ray does.")});
}

Claims stepClaims() {
  return claimsAbout<RayAtTriangle>({
      {"Two sides of the triangle, both from {P0}.", always},
      {"From {Q} to {P0}.", always},
      {"First the plane: so many steps {r} lead from {Q} to it.", crosses},
      {"The point of the plane. Is it in the triangle?", crosses},
      {"From {P0} to {I}.", crosses},
      {"It belongs to the triangle alone, and is 0 only when that has no area.", isProper},
      {"Zero: u and v lie on one line. There is nothing to divide by, whatever the ray does.", isFlat},
      {"v⊥ cannot see v: only s is left.", crosses},
      {"u⊥ cannot see u: only t is left.", crosses},
      {"In the triangle's plane, perpendicular to u.", isProper},
      {"Likewise, perpendicular to v.", isProper},
      {"Used in two determinants.", always},
      {"Used in the two others.", always},
      {"Zero, because {r} is the zero vector: there is no ray.",
       [](const RayAtTriangle &at) { return !at.isRay(); }},
      {"Zero: nothing to divide by. Either the line of the ray does not cross the plane, or there is no "
       "triangle.",
       [](const RayAtTriangle &at) { return at.isRay() && at.rn == 0; }},
      {"Not zero: there is exactly one answer.", crosses},
      {"c in the place of u.", always},
      {"c in the place of v.", always},
      {"c in the place of {r}.", always},
      {"The third side.", always},
      {"The moment of the ray's line.", always},
      {"The moments of the three edges.", always},
      {"With the edge {edge}, opposite to its corner.",
       [](const RayAtTriangle &, const Said &said) {
         return isEdgeOppositeTo(std::stoul(said.line.substr(1)), said.at("edge"));
       }},
      {"Zero, as {r}·n is: no single point can be mixed.",
       [](const RayAtTriangle &at) { return at.rn == 0; }},
      {"All products together.", crosses},
      {"The corners, mixed. No normal was needed.", crosses},
      {"Only now the ray's own parameter, which the products do not have.", crosses},
      {"{quotient}, which would be {letter}, is not defined: nothing can be divided by 0.",
       [](const RayAtTriangle &at) { return at.rn == 0; }},
      {"{once} multiplications belong to the triangle alone and can be kept, {ray} are new for each ray. "
       "Besides: {additions} additions and {divisions} divisions.",
       [](const RayAtTriangle &, const Said &said) { return isCountOf(said); }},
  });
}

Claims agreementClaims() {
  return claimsAbout<RayAtTriangle>({
      {"One number in all three ways, and it is 0.", [](const RayAtTriangle &at) { return at.rn == 0; }},
      {"One number in all three ways.", crosses},
      {"Two determinants are products with edges, the third is a dot product of the first way.", always},
      {"All are 0, because {r} is the zero vector: there is no line.",
       [](const RayAtTriangle &at) { return !at.isRay(); }},
      {"No two differ in sign: the line of the ray goes through the triangle. The products do not know where "
       "the ray starts.",
       [](const RayAtTriangle &at) { return at.isBehind(); }},
      {"No two differ in sign: the line of the ray goes through the triangle.",
       [](const RayAtTriangle &at) { return at.hits(); }},
      // corners on one line, which the ray's line does not meet, may be passed on both sides, too
      {"Two differ in sign: the line of the ray passes outside. Nothing was divided.",
       [](const RayAtTriangle &at) {
         return at.misses() || at.isParallel() || (isFlat(at) && at.isRay() && !isCoplanar(at));
       }},
      {"All are 0: the line of the ray and the corners lie in one plane.", isCoplanar},
      {"Three ways, the same two numbers.", crosses},
      {"Negative: the ray does not get there.",
       [](const RayAtTriangle &at) { return at.crosses() && at.lambda() < 0; }},
      {"Not negative: the ray gets there.",
       [](const RayAtTriangle &at) { return at.crosses() && at.lambda() >= 0; }},
  });
}

} // namespace

namespace claims {

Claims three_methods() {
  return together({caseClaims(), crossingClaims(), stepClaims(), agreementClaims(), crossProductClaims(),
                   zeroPerpClaims(), zeroDirectionClaims(1)});
}

} // namespace claims
} // namespace halfspace::test
