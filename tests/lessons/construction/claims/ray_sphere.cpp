#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/sphere.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

/// The power of the start and the distance of the line tell all: no root is taken.
struct RayAtSphere {
  explicit RayAtSphere(Objects objects)
      : S(objectAs<SphereObject>(*objects[0]).value()), L(objectAs<RayObject>(*objects[1]).value()),
        w(L.origin - S.center), rr(product(L.direction, L.direction)), rw(product(L.direction, w)),
        power(product(w, w) - S.radius * S.radius) {
    const ExactVec3 moment = perpendicular(w, L.direction);
    reach = S.radius * S.radius * rr - product(moment, moment);
  }

  bool isSphere() const { return S.radius != 0; }
  bool isLine() const { return isSphere() && rr != 0; }
  bool isCut() const { return isLine() && reach > 0; }
  bool isTouched() const { return isLine() && reach == 0; }
  bool isMissed() const { return isLine() && reach < 0; }

  bool startsOutside() const { return isSphere() && power > 0; }
  bool startsOn() const { return isSphere() && power == 0; }
  bool startsInside() const { return isSphere() && power < 0; }
  /// The middle of what is common lies ahead of the start, or behind it.
  bool leadsTowards() const { return rw < 0; }
  bool leadsAway() const { return rw > 0; }

  SphereObject S;
  RayObject L;
  ExactVec3 w; ///< from the centre to the start
  Rational rr, rw;
  Rational power;
  Rational reach; ///< positive where the line is nearer to the centre than the radius
};

bool isLine(const RayAtSphere &at) { return at.isLine(); }
bool isCut(const RayAtSphere &at) { return at.isCut(); }
bool isTouched(const RayAtSphere &at) { return at.isTouched(); }
bool isMissed(const RayAtSphere &at) { return at.isMissed(); }

} // namespace

namespace claims {

Claims ray_sphere() {
  return claimsAbout<RayAtSphere>({
      {"This is k: the same for every line through {Q} that meets the sphere twice.", isCut},
      {"The radius is 0: the sphere is only the point {c}.",
       [](const RayAtSphere &at) { return !at.isSphere(); }},
      {"The direction {r} is the zero vector: the ray goes nowhere.",
       [](const RayAtSphere &at) { return at.rr == 0; }},
      {"{t1} and {t2} are both negative: the sphere is behind the ray's start.",
       [](const RayAtSphere &at) { return at.isCut() && at.startsOutside() && at.leadsAway(); }},
      {"The ray enters the sphere at {H1}, with {t1}, and leaves it at {H2}, with {t2}.",
       [](const RayAtSphere &at) { return at.isCut() && at.startsOutside() && at.leadsTowards(); }},
      {"The ray starts inside: {t1} is behind its start, and it leaves the sphere at {H2}, with {t2}.",
       [](const RayAtSphere &at) { return at.isLine() && at.startsInside(); }},
      {"The ray starts on the sphere, goes inside and leaves it at {H2}, with {t2}.",
       [](const RayAtSphere &at) { return at.isLine() && at.startsOn() && at.leadsTowards(); }},
      {"The ray starts on the sphere and leads away from it: it has only its start, {H2}, in common with it.",
       [](const RayAtSphere &at) { return at.isLine() && at.startsOn() && at.leadsAway(); }},
      {"D = 0: the ray touches the sphere in one point, {H}, with {t}.",
       [](const RayAtSphere &at) { return at.isTouched() && !at.leadsAway(); }},
      {"D = 0: the line touches the sphere in one point, {H}. But {t} is negative: it is behind the ray's "
       "start.",
       [](const RayAtSphere &at) { return at.isTouched() && at.leadsAway(); }},
      {"{D} is negative and has no real square root: no t fits, and the line of the ray misses the sphere.",
       isMissed},
      {"From the centre {c} to the start {Q}.", always},
      {"Positive: {Q} is outside the sphere.", [](const RayAtSphere &at) { return at.startsOutside(); }},
      {"Negative: {Q} is inside the sphere.", [](const RayAtSphere &at) { return at.startsInside(); }},
      {"Zero: {Q} is on the sphere.", [](const RayAtSphere &at) { return at.startsOn(); }},
      {"A quadratic equation: its solutions are the t where the line meets the sphere.", isLine},
      {"Positive: it has a root, and two t fit.", isCut},
      {"Zero: only one t fits. The line touches the sphere.", isTouched},
      {"Negative: it has no real square root, and no t fits. The line misses the sphere.", isMissed},
      {"√D is 0, so both solutions are this one.", isTouched},
      {"No t is negative: what the line meets, the ray meets too.",
       [](const RayAtSphere &at) {
         return !at.isMissed() && at.isLine() && !at.startsInside() && !at.leadsAway();
       }},
      {"Only one t is not negative: the ray meets the sphere once.",
       [](const RayAtSphere &at) {
         return at.isCut() && (at.startsInside() || (at.startsOn() && at.leadsAway()));
       }},
      {"No t ≥ 0: the line meets the sphere, but only behind the start. The ray misses it.",
       [](const RayAtSphere &at) {
         return !at.isMissed() && at.isLine() && at.startsOutside() && at.leadsAway();
       }},
      {"From the centre outwards. Divided by {R} it is one unit long.",
       [](const RayAtSphere &at) { return at.isCut() || at.isTouched(); }},
      {"The line's point nearest to the centre: without the root, t is −b/a.", isLine},
      {"How far the line passes from the centre.", isLine},
      {"Half of the chord, by Pythagoras: {R} is the longest side.",
       [](const RayAtSphere &at) { return at.isCut() && !vanishes(perpendicular(at.w, at.L.direction)); }},
      {"The chord goes through the centre, so its half is as long as {R}.",
       [](const RayAtSphere &at) { return at.isCut() && vanishes(perpendicular(at.w, at.L.direction)); }},
      {"h < {R}: the discriminant is positive.", isCut},
      {"h = {R}: the discriminant is 0.", isTouched},
      {"h > {R}: the discriminant is negative.", isMissed},
  });
}

} // namespace claims
} // namespace halfspace::test
