#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/claims/line_at_sphere.h"

namespace halfspace::test {
namespace {

struct RayAtSphere : LineAtSphere {
  explicit RayAtSphere(Objects objects)
      : RayAtSphere(objectAs<SphereObject>(*objects[0]).value(), objectAs<RayObject>(*objects[1]).value()) {}
  RayAtSphere(const SphereObject &sphere, const RayObject &L)
      : LineAtSphere(sphere, {L.origin, L.direction}) {}

  /// The middle of what is common lies ahead of the start, or behind it.
  bool leadsTowards() const { return vw < 0; }
  bool leadsAway() const { return vw > 0; }
};

} // namespace

namespace claims {

Claims ray_sphere() {
  return together(
      {lineAtSphereClaims<RayAtSphere>(),
       claimsAbout<RayAtSphere>({
           {"The radius is 0: the sphere is only the point {c}.",
            [](const RayAtSphere &at) { return !at.isSphere(); }},
           {"The direction {r} is the zero vector: the ray goes nowhere.",
            [](const RayAtSphere &at) { return at.vv == 0; }},
           {"{t1} and {t2} are both negative: the sphere is behind the ray's start.",
            [](const RayAtSphere &at) { return at.isCut() && at.startsOutside() && at.leadsAway(); }},
           {"The ray enters the sphere at {H1}, with {t1}, and leaves it at {H2}, with {t2}.",
            [](const RayAtSphere &at) { return at.isCut() && at.startsOutside() && at.leadsTowards(); }},
           {"The ray starts inside: {t1} is behind its start, and it leaves the sphere at {H2}, with {t2}.",
            [](const RayAtSphere &at) { return at.isLine() && at.startsInside(); }},
           {"The ray starts on the sphere, goes inside and leaves it at {H2}, with {t2}.",
            [](const RayAtSphere &at) { return at.isLine() && at.startsOn() && at.leadsTowards(); }},
           {"The ray starts on the sphere and leads away from it: it has only its start, {H2}, in common "
            "with it.",
            [](const RayAtSphere &at) { return at.isLine() && at.startsOn() && at.leadsAway(); }},
           {"D = 0: the ray touches the sphere in one point, {H}, with {t}.",
            [](const RayAtSphere &at) { return at.isTouched() && !at.leadsAway(); }},
           {"D = 0: the line touches the sphere in one point, {H}. But {t} is negative: it is behind the "
            "ray's start.",
            [](const RayAtSphere &at) { return at.isTouched() && at.leadsAway(); }},
           {"{D} is negative and has no real square root: no t fits, and the line of the ray misses the "
            "sphere.",
            isMissed},
           {"From the centre {c} to the start {Q}.", always},
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
       })});
}

} // namespace claims
} // namespace halfspace::test
