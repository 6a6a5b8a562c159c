#include "tests/lessons/construction/claims/ray_at_plane.h"

namespace halfspace::test {
namespace {

struct RayInPicture : RayAtPlane {
  explicit RayInPicture(Objects objects) : RayAtPlane(objects), D(product(E.point, E.normal)) {}

  Rational D; ///< of the plane's equation n·x = D
};

bool isPlane(const RayInPicture &at) { return at.isPlane(); }
bool isNoPlane(const RayInPicture &at) { return !at.isPlane(); }
bool crosses(const RayInPicture &at) { return at.crosses(); }
/// The line through the origin along n, the plane, and the start that is on neither.
bool isRectangle(const RayInPicture &at) {
  return at.isPlane() && !vanishes(perpendicular(at.L.origin, at.E.normal)) && at.height != 0;
}
bool runsAlongNormal(const RayInPicture &at) { return vanishes(perpendicular(at.L.direction, at.E.normal)); }

Claims caseClaims() {
  return claimsAbout<RayInPicture>({
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.", isNoPlane},
      {"The direction {r} is the zero vector: the ray goes nowhere.",
       [](const RayInPicture &at) { return !at.isRay(); }},
      {"{v0}: {Q} lies in the plane, and the ray hits it at its own start.",
       [](const RayInPicture &at) { return at.crosses() && at.height == 0; }},
      {"{t} is positive: the ray hits the plane after so many steps {r}.",
       [](const RayInPicture &at) { return at.crosses() && at.t() > 0; }},
      {"{t} is negative: the plane is behind the ray's start.",
       [](const RayInPicture &at) { return at.crosses() && at.t() < 0; }},
      {"{r} has no part along {n}: the ray runs parallel to the plane and never meets it.",
       [](const RayInPicture &at) { return at.isPlane() && at.isRay() && at.rn == 0 && at.height != 0; }},
      {"{r} has no part along {n}, and {Q} is in the plane: the whole ray lies in it, and no single point is "
       "the hit.",
       [](const RayInPicture &at) { return at.isPlane() && at.isRay() && at.rn == 0 && at.height == 0; }},
  });
}

Claims wayClaims() {
  return claimsAbout<RayInPicture>({
      {"Positive: the plane lies on that side of the origin to which {n} points.",
       [](const RayInPicture &at) { return at.D > 0; }},
      {"Negative: from the origin to the plane you go against {n}.",
       [](const RayInPicture &at) { return at.D < 0; }},
      {"Zero: the plane passes through the origin.",
       [](const RayInPicture &at) { return at.isPlane() && at.D == 0; }},
      {"Zero, because {n} is the zero vector: there is no plane.", isNoPlane},
      {"The point of the plane that is nearest to the origin. When |{n}| = 1, the denominator is 1, and it "
       "is D·{n}.",
       isPlane},
      {"Positive: each step {r} goes to the side that {n} points to.",
       [](const RayInPicture &at) { return at.rn > 0; }},
      {"Negative: each step {r} goes against {n}.", [](const RayInPicture &at) { return at.rn < 0; }},
      {"Zero: no step gains anything along {n}.",
       [](const RayInPicture &at) { return at.isPlane() && at.rn == 0; }},
      {"One step from {Q}.", always},
      {"The foot of F on the line through {Q} along {n}.", isPlane},
      {"The foot of {Q} on the line through the origin along {n}.", isPlane},
      {"From where {Q} is, along {n}, to where the plane is.", isPlane},
      {"The foot of {Q} in the plane.", isPlane},
      {"Opposite sides of a rectangle: the same arrow.", isRectangle},
      {"The same arrow, though the four points are no corners of a rectangle here.",
       [](const RayInPicture &at) { return at.isPlane() && !isRectangle(at); }},
      {"How far the plane is from the origin.", isPlane},
      {"How far one step leads along {n}.", isPlane},
      {"How far {Q} is from the plane.", isPlane},
  });
}

Claims meetingClaims() {
  return claimsAbout<RayInPicture>({
      {"It takes this many steps {r} to get from {Q} to the plane.", crosses},
      {"Along {n}: t times the side of the small triangle is that of the large one.",
       [](const RayInPicture &at) { return at.crosses() && at.height != 0 && !runsAlongNormal(at); }},
      {"Along {n}: t times what a step gains. There are no triangles here, because the ray runs along {n}.",
       [](const RayInPicture &at) { return at.crosses() && runsAlongNormal(at); }},
      {"Along {n}: t is 0, because {Q} is in the plane already, and there is only one triangle.",
       [](const RayInPicture &at) { return at.crosses() && at.height == 0 && !runsAlongNormal(at); }},
      {"Along the ray, too: t times the step.", crosses},
      {"The point where the ray meets the plane.",
       [](const RayInPicture &at) { return at.crosses() && at.t() >= 0; }},
      {"Only the line backwards meets the plane there.",
       [](const RayInPicture &at) { return at.crosses() && at.t() < 0; }},
      {"v_d is positive: the ray goes to the side that {n} points to, so take −{n}.",
       [](const RayInPicture &at) { return at.rn > 0; }},
      {"v_d is negative: the ray goes against {n}, so take {n}.",
       [](const RayInPicture &at) { return at.rn < 0; }},
  });
}

} // namespace

namespace claims {

Claims ray_plane_picture() { return together({caseClaims(), wayClaims(), meetingClaims()}); }

} // namespace claims
} // namespace halfspace::test
