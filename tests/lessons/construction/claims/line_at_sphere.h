// A line and a sphere, as several constructions look at them.
#pragma once

#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/sphere.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {

/// The power of the line's point and the distance of the line tell all: no root is taken.
struct LineAtSphere {
  LineAtSphere(const SphereObject &sphere, const LineObject &line)
      : S(sphere), g(line), w(g.point - S.center), vv(product(g.direction, g.direction)),
        vw(product(g.direction, w)), power(product(w, w) - S.radius * S.radius),
        moment(perpendicular(w, g.direction)), reach(S.radius * S.radius * vv - product(moment, moment)) {}

  bool isSphere() const { return S.radius != 0; }
  bool isLine() const { return isSphere() && vv != 0; }
  bool isCut() const { return isLine() && reach > 0; }
  bool isTouched() const { return isLine() && reach == 0; }
  bool isMissed() const { return isLine() && reach < 0; }
  bool isThroughCenter() const { return vanishes(moment); }

  bool startsOutside() const { return isSphere() && power > 0; }
  bool startsOn() const { return isSphere() && power == 0; }
  bool startsInside() const { return isSphere() && power < 0; }

  SphereObject S;
  LineObject g;
  ExactVec3 w; ///< from the centre to the line's point
  Rational vv, vw;
  Rational power;
  ExactVec3 moment; ///< of the line about the centre
  Rational reach;   ///< positive where the line is nearer to the centre than the radius
};

inline bool isLine(const LineAtSphere &at) { return at.isLine(); }
inline bool isCut(const LineAtSphere &at) { return at.isCut(); }
inline bool isTouched(const LineAtSphere &at) { return at.isTouched(); }
inline bool isMissed(const LineAtSphere &at) { return at.isMissed(); }
inline bool startsOutside(const LineAtSphere &at) { return at.startsOutside(); }
inline bool startsOn(const LineAtSphere &at) { return at.startsOn(); }
inline bool startsInside(const LineAtSphere &at) { return at.startsInside(); }

/// The sentences of the equation, of the contacts and of the right triangle.
template <class Scene> [[nodiscard]] Claims lineAtSphereClaims() {
  return claimsAbout<Scene>({
      {"This is k: the same for every line through {Q} that meets the sphere twice.", isCut},
      {"Positive: {Q} is outside the sphere.", startsOutside},
      {"Negative: {Q} is inside the sphere.", startsInside},
      {"Zero: {Q} is on the sphere.", startsOn},
      {"A quadratic equation: its solutions are the t where the line meets the sphere.", isLine},
      {"Positive: it has a root, and two t fit.", isCut},
      {"Zero: only one t fits. The line touches the sphere.", isTouched},
      {"Negative: it has no real square root, and no t fits. The line misses the sphere.", isMissed},
      {"√D is 0, so both solutions are this one.", isTouched},
      {"From the centre outwards. Divided by {R} it is one unit long.",
       [](const Scene &at) { return at.isCut() || at.isTouched(); }},
      {"The line's point nearest to the centre: without the root, t is −b/a.", isLine},
      {"How far the line passes from the centre.", isLine},
      {"Half of the chord, by Pythagoras: {R} is the longest side.",
       [](const Scene &at) { return at.isCut() && !at.isThroughCenter(); }},
      {"The chord goes through the centre, so its half is as long as {R}.",
       [](const Scene &at) { return at.isCut() && at.isThroughCenter(); }},
      {"h < {R}: the discriminant is positive.", isCut},
      {"h = {R}: the discriminant is 0.", isTouched},
      {"h > {R}: the discriminant is negative.", isMissed},
  });
}

} // namespace halfspace::test
