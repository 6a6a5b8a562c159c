#include "tests/lessons/construction/claims/line_at_sphere.h"

namespace halfspace::test {
namespace {

struct LineThenSphere : LineAtSphere {
  explicit LineThenSphere(Objects objects)
      : LineAtSphere(objectAs<SphereObject>(*objects[1]).value(), objectAs<LineObject>(*objects[0]).value()) {
  }
};

} // namespace

namespace claims {

Claims line_sphere() {
  return together(
      {lineAtSphereClaims<LineThenSphere>(),
       claimsAbout<LineThenSphere>({
           {"The radius is 0: the sphere is only the point {c}.",
            [](const LineThenSphere &at) { return !at.isSphere() && at.vv == 0; }},
           {"The radius is 0: the sphere is only the point {c}, and the line {g} goes through it.",
            [](const LineThenSphere &at) { return !at.isSphere() && at.vv != 0 && at.isThroughCenter(); }},
           {"The radius is 0: the sphere is only the point {c}, and the line {g} passes beside it.",
            [](const LineThenSphere &at) { return !at.isSphere() && at.vv != 0 && !at.isThroughCenter(); }},
           {"The direction {v} is the zero vector: it points nowhere, so there is no line.",
            [](const LineThenSphere &at) { return at.vv == 0; }},
           {"{D} is positive: the line {g} meets the sphere in two points, {H1} with {t1} and {H2} with "
            "{t2}.",
            isCut},
           {"{D}: the line {g} touches the sphere in one point, {H1}, with {t1}.", isTouched},
           {"{D} is negative and has no real square root: no t fits, and the line {g} misses the sphere.",
            isMissed},
           {"From the centre {c} to {A}.", always},
       })});
}

} // namespace claims
} // namespace halfspace::test
