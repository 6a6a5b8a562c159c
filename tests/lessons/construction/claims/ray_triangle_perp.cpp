#include "tests/lessons/construction/claims/ray_at_triangle.h"

namespace halfspace::test {
namespace {

/// Of the triangle's own parameter, the weight of its third corner.
Rational tOf(const RayAtTriangle &at) { return at.weights()[2]; }

bool isProper(const RayAtTriangle &at) { return at.isTriangle(); }
bool crosses(const RayAtTriangle &at) { return at.crosses(); }
bool isBehind(const RayAtTriangle &at) { return at.isBehind(); }

} // namespace

namespace claims {

Claims ray_triangle_perp() {
  const Claims own = claimsAbout<RayAtTriangle>({
      {"The line meets the triangle's plane outside the triangle: {s}, {t}, {sum}.",
       [](const RayAtTriangle &at) { return at.misses(); }},
      {"{r}·n = 0: the ray runs parallel to the triangle's plane and never meets it.",
       [](const RayAtTriangle &at) { return at.isParallel(); }},
      {"{r}·n = 0 and {Q} lies in the triangle's plane: the ray runs inside it, and no single point is the "
       "hit.",
       [](const RayAtTriangle &at) { return at.isInPlane(); }},
      {"{P0}, {P1} and {P2} lie on one line: (u·v)² equals (u·u)(v·v), so the denominator is 0 and there is "
       "no triangle to hit.",
       [](const RayAtTriangle &at) {
         const Rational uv = product(at.u, at.v);
         return at.isCollinear() && uv * uv == product(at.u, at.u) * product(at.v, at.v);
       }},
      {"Two sides of the triangle, both from {P0}.", always},
      {"Three of the five dot products: they belong to the triangle alone.", always},
      {"u perp: in the plane of the triangle and perpendicular to u.", isProper},
      {"v perp likewise: perpendicular to v.", isProper},
      {"The denominator of s and t. It is zero only when the corners lie on one line.", isProper},
      {"Zero: u and v do not span a triangle, and there is nothing to divide by.",
       [](const RayAtTriangle &at) { return !at.isTriangle(); }},
      {"First the triangle's plane: so many steps {r} lead from {Q} to it.", crosses},
      {"The point of the plane that the ray's line goes through. Is it in the triangle?", crosses},
      {"From {P0} to {I}.", crosses},
      {"The last two of the five dot products.", always},
      {"In the dot product with v⊥ the part t·v drops out, and only s is left.", crosses},
      {"In the dot product with u⊥ the part s·u drops out, and only t is left. v·u⊥ is −G, so the signs in "
       "the numerator have changed too. This t belongs to the triangle; the ray's own parameter is λ.",
       crosses},
      {"The point belongs to the triangle when none of s, t and 1 − s − t is negative. Here it is outside "
       "the "
       "triangle.",
       [](const RayAtTriangle &at) { return at.misses(); }},
      {"How far w reaches along u⊥, times the length of u⊥.", crosses},
      {"The same for v.", crosses},
      {"t is 0: {A} and {C} are {P0} itself, and there is no triangle {P0}{A}{C}.",
       [](const RayAtTriangle &at) { return at.crosses() && tOf(at) == 0; }},
      {"u and v are perpendicular: {B} is {P2} itself and {A} is {C}, so the triangles are flat. Along u⊥, "
       "t·v is to v as a is to b all the same.",
       [](const RayAtTriangle &at) { return at.crosses() && product(at.u, at.v) == 0; }},
      {"The right triangles {P0}{A}{C} and {P0}{B}{P2} have the same shape, so t·v is to v as a is to b. The "
       "length of u⊥ stands in both and cancels.",
       [](const RayAtTriangle &at) { return at.crosses() && tOf(at) != 0 && product(at.u, at.v) != 0; }},
  });
  return together(
      {own, hitClaims(),
       placeClaims(isBehind,
                   "{lambda} is negative: the triangle is behind the ray's start. The line backwards would "
                   "meet it inside the triangle.",
                   "{lambda} is negative: the triangle is behind the ray's start. The line backwards would "
                   "meet it on the edge {edge}.",
                   "{lambda} is negative: the triangle is behind the ray's start. The line backwards would "
                   "meet it at the corner {corner}."),
       placeClaims(crosses,
                   "The point belongs to the triangle when none of s, t and 1 − s − t is negative. Here it "
                   "is inside the triangle.",
                   "The point belongs to the triangle when none of s, t and 1 − s − t is negative. Here it "
                   "is on the edge {edge}.",
                   "The point belongs to the triangle when none of s, t and 1 − s − t is negative. Here it "
                   "is at the corner {corner}."),
       coincidenceClaims(
           "{first} and {second} are the same point: this is no triangle, and the denominator is 0.",
           "{first}, {second} and {third} are the same point: this is no triangle, and the denominator is "
           "0."),
       crossProductClaims(), zeroPerpClaims(), zeroDirectionClaims(1)});
}

} // namespace claims
} // namespace halfspace::test
