#include "tests/lessons/construction/claims/ray_at_plane.h"
#include "tests/lessons/construction/claims/said_angle.h"

namespace halfspace::test {
namespace {

struct AtMirror : RayAtPlane {
  explicit AtMirror(Objects objects) : RayAtPlane(objects) {}

  bool isProper() const { return isRay() && isPlane(); }
  bool hits() const { return crosses() && t() >= 0; }
  bool isPerpendicular() const { return crosses() && vanishes(perpendicular(E.normal, L.direction)); }
  /// The direction from H to the mirror image of the place that the ray would have come to without the
  /// mirror, times n·n.
  ExactVec3 reflected() const {
    return L.direction * product(E.normal, E.normal) - E.normal * Rational(2 * rn);
  }
};

bool isProper(const AtMirror &at) { return at.isProper(); }

} // namespace

namespace claims {

Claims reflection() {
  return claimsAbout<AtMirror>({
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const AtMirror &at) { return !at.isPlane(); }},
      {"The direction {r} is the zero vector: the ray goes nowhere.",
       [](const AtMirror &at) { return !at.isRay(); }},
      {"{r} runs straight along {n}: the mirror sends the ray straight back.",
       [](const AtMirror &at) {
         return at.hits() && at.isPerpendicular() &&
                vanishes(perpendicular(at.reflected(), at.L.direction)) &&
                product(at.reflected(), at.L.direction) < 0;
       }},
      {"t = 0: the ray starts in the mirror, and is turned there.",
       [](const AtMirror &at) { return at.crosses() && at.height == 0; }},
      {"The ray hits the mirror: its part along {n} turns round, and its part across stays.",
       [](const AtMirror &at) { return at.hits() && at.height != 0 && !at.isPerpendicular(); }},
      {"{t} is negative: the mirror is behind the ray's start. Only the line of the ray meets it, so the ray "
       "is not reflected.",
       [](const AtMirror &at) { return at.crosses() && at.t() < 0; }},
      {"{r}·{n} = 0: the ray runs beside the mirror and never meets it. Nothing turns round.",
       [](const AtMirror &at) { return at.isProper() && at.rn == 0 && at.height != 0; }},
      {"{r}·{n} = 0 and {Q} is in the mirror: the ray runs along in it. Nothing turns round.",
       [](const AtMirror &at) { return at.isProper() && at.rn == 0 && at.height == 0; }},
      {"It takes this many steps {r} to get from {Q} to the mirror.",
       [](const AtMirror &at) { return at.crosses(); }},
      {"The point where the ray meets the mirror.", [](const AtMirror &at) { return at.hits(); }},
      {"Only the line of the ray meets the mirror there, behind the start.",
       [](const AtMirror &at) { return at.crosses() && at.t() < 0; }},
      {"Negative: {r} goes against {n}.", [](const AtMirror &at) { return at.rn < 0; }},
      {"Positive: {r} goes to the side that {n} points to.", [](const AtMirror &at) { return at.rn > 0; }},
      {"Zero: {r} runs along the mirror and has no part along {n}.",
       [](const AtMirror &at) { return at.isProper() && at.rn == 0; }},
      {"The part of {r} along {n}: {r} projected onto {n}.", isProper},
      {"The zero vector: {r} runs straight along {n}.",
       [](const AtMirror &at) { return at.isPerpendicular(); }},
      {"What is left: the part of {r} across {n}.",
       [](const AtMirror &at) {
         return at.isProper() && !vanishes(perpendicular(at.E.normal, at.L.direction));
       }},
      {"The part across stays, and the part along {n} turns round.",
       [](const AtMirror &at) { return at.crosses(); }},
      {"The direction in which the mirror sends the ray.", [](const AtMirror &at) { return at.hits(); }},
      {"The direction in which the mirror would send light that came along this line.",
       [](const AtMirror &at) { return at.crosses() && at.t() < 0; }},
      {"Light that came to the plane in this direction would make it so bright.",
       [](const AtMirror &at) { return at.crosses() && at.t() < 0; }},
      {"{r} itself: there is nothing to turn round.",
       [](const AtMirror &at) { return at.isProper() && at.rn == 0; }},
      {"The same number: both are equally long.",
       [](const AtMirror &at) {
         const Rational nn = product(at.E.normal, at.E.normal);
         return product(at.reflected(), at.reflected()) == product(at.L.direction, at.L.direction) * nn * nn;
       }},
      {"θ{degrees}°: the angle between −{r}, which leads back, and {n}.",
       [](const AtMirror &at, const Said &said) {
         return at.isProper() && isAngleBetween(ExactVec3(-at.L.direction), at.E.normal, said.at("degrees"));
       }},
      {"θ′{degrees}°: the angle between {reflected} and {n}. It is as large as θ.",
       [](const AtMirror &at, const Said &said) {
         return at.isProper() && isAngleBetween(at.reflected(), at.E.normal, said.at("degrees")) &&
                isAngleBetween(ExactVec3(-at.L.direction), at.E.normal, said.at("degrees"));
       }},
      {"0: the light runs along the plane and does not make it bright.",
       [](const AtMirror &at) { return at.isProper() && at.rn == 0; }},
      {"1: light straight along {n} makes the plane as bright as can be.",
       [](const AtMirror &at) { return at.hits() && at.isPerpendicular(); }},
      {"Less than 1: the light falls at a slant, so it is spread over more of the plane.",
       [](const AtMirror &at) { return at.hits() && !at.isPerpendicular(); }},
  });
}

} // namespace claims
} // namespace halfspace::test
