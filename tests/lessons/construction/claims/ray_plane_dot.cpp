#include "tests/lessons/construction/claims/ray_at_plane.h"

namespace halfspace::test {
namespace claims {

Claims ray_plane_dot() {
  return claimsAbout<RayAtPlane>({
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const RayAtPlane &at) { return !at.isPlane(); }},
      {"The direction {r} is the zero vector: the ray goes nowhere.",
       [](const RayAtPlane &at) { return !at.isRay(); }},
      {"{n} is the zero vector: there is no plane.", [](const RayAtPlane &at) { return !at.isPlane(); }},
      {"{r} is the zero vector: there is no ray.", [](const RayAtPlane &at) { return !at.isRay(); }},
      {"t = 0: the ray starts in the plane, so it hits at its own start.",
       [](const RayAtPlane &at) { return at.crosses() && at.height == 0; }},
      {"{t} is positive: the ray hits the plane.",
       [](const RayAtPlane &at) { return at.crosses() && at.t() > 0; }},
      {"{t} is negative: the plane is behind the ray's start, so the ray does not hit it.",
       [](const RayAtPlane &at) { return at.crosses() && at.t() < 0; }},
      {"{r}·{n} = 0 but ({P0} − {Q})·{n} is not: the ray runs parallel to the plane and never meets it.",
       [](const RayAtPlane &at) { return at.isRay() && at.isPlane() && at.rn == 0 && at.height != 0; }},
      {"{r}·{n} = 0 and ({P0} − {Q})·{n} = 0: the ray lies in the plane. Every t fits, so 0/0 names no "
       "single point.",
       [](const RayAtPlane &at) { return at.isRay() && at.isPlane() && at.rn == 0 && at.height == 0; }},
      {"The ray's points {Q} + t·{r} put into the plane's equation. One unknown is left: t.",
       [](const RayAtPlane &at) { return at.isPlane() && at.isRay(); }},
      {"Collected by t: {r}·{n} is the coefficient of t, and f({Q}) the constant term.",
       [](const RayAtPlane &at) { return at.rn != 0; }},
      {"{r}·{n} is 0, and so is f({Q}): t drops out, and every t satisfies 0 = 0.",
       [](const RayAtPlane &at) { return at.rn == 0 && at.height == 0; }},
      {"{r}·{n} is 0: t drops out, and f({Q}) is not 0, so no t satisfies the equation.",
       [](const RayAtPlane &at) { return at.rn == 0 && at.height != 0; }},
      {"This is −f({Q}). It says how far the plane is from {Q} along {n}, times |{n}|: a distance only when "
       "|{n}| = 1, or when it is 0.",
       [](const RayAtPlane &at) { return at.isPlane(); }},
      {"How far one step {r} goes along {n}, times |{n}|. Zero means that no step comes nearer to the plane.",
       [](const RayAtPlane &at) { return at.isPlane() && at.isRay(); }},
      {"It takes this many steps {r} to get from {Q} to the plane. This is a distance only when |{r}| = 1, "
       "or when it is 0.",
       [](const RayAtPlane &at) { return at.crosses(); }},
      {"The zero vector: {Q} lies in the plane.",
       [](const RayAtPlane &at) { return at.isPlane() && at.height == 0; }},
      {"From {Q} straight to the plane, along {n}.",
       [](const RayAtPlane &at) { return at.isPlane() && at.height != 0; }},
      {"The zero vector: {r} does not lead nearer to the plane.",
       [](const RayAtPlane &at) { return at.isPlane() && at.isRay() && at.rn == 0; }},
      {"The part of {r} along {n}: what one step brings.",
       [](const RayAtPlane &at) { return at.isPlane() && at.rn != 0; }},
      {"What is left is t times what one step brings.", [](const RayAtPlane &at) { return at.crosses(); }},
      {"The point where the ray meets the plane.",
       [](const RayAtPlane &at) { return at.crosses() && at.t() >= 0; }},
      {"Here the line through the ray meets the plane, behind the start: the ray itself never gets there.",
       [](const RayAtPlane &at) { return at.crosses() && at.t() < 0; }},
      {"{r}·{n} is positive: {r} goes to the side that {n} points to. So the facing normal is −{n}, made one "
       "unit long.",
       [](const RayAtPlane &at) { return at.rn > 0; }},
      {"{r}·{n} is negative: {r} goes against {n}. So the facing normal is {n}, made one unit long.",
       [](const RayAtPlane &at) { return at.rn < 0; }},
  });
}

} // namespace claims
} // namespace halfspace::test
