#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/sphere.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

/// The square of f(c) against that of R times the normal: nothing is divided, no root is taken.
struct PlaneAtSphere {
  explicit PlaneAtSphere(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), S(objectAs<SphereObject>(*objects[1]).value()),
        f(product(E.normal, S.center) - product(E.normal, E.point)),
        reach(S.radius * S.radius * product(E.normal, E.normal) - f * f) {}

  bool isPlane() const { return !vanishes(E.normal); }
  bool areBoth() const { return isPlane() && S.radius != 0; }
  bool isCut() const { return areBoth() && reach > 0; }
  bool isTouched() const { return areBoth() && reach == 0; }
  bool isMissed() const { return areBoth() && reach < 0; }
  bool isThroughCenter() const { return isPlane() && f == 0; }

  PlaneObject E;
  SphereObject S;
  Rational f;
  Rational reach; ///< positive where the plane is nearer to the centre than the radius
};

bool isCut(const PlaneAtSphere &at) { return at.isCut(); }
bool isTouched(const PlaneAtSphere &at) { return at.isTouched(); }
bool isMissed(const PlaneAtSphere &at) { return at.isMissed(); }
bool areBoth(const PlaneAtSphere &at) { return at.areBoth(); }

} // namespace

namespace claims {

Claims plane_sphere() {
  return claimsAbout<PlaneAtSphere>({
      {"The radius is 0: the sphere is only the point {c}.",
       [](const PlaneAtSphere &at) { return at.S.radius == 0 && !at.isPlane(); }},
      {"The radius is 0: the sphere is only the point {c}, which lies in the plane {E}.",
       [](const PlaneAtSphere &at) { return at.S.radius == 0 && at.isThroughCenter(); }},
      {"The radius is 0: the sphere is only the point {c}, which does not lie in the plane {E}.",
       [](const PlaneAtSphere &at) { return at.S.radius == 0 && at.f != 0; }},
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const PlaneAtSphere &at) { return !at.isPlane(); }},
      {"{h} is less than {R}: the plane {E} cuts the sphere in a circle around {M}, whose radius is {rho}.",
       [](const PlaneAtSphere &at) { return at.isCut() && at.f != 0; }},
      {"{h}: the plane {E} goes through the centre, and cuts the sphere in a great circle. Its radius is "
       "{R}, as that of the sphere.",
       [](const PlaneAtSphere &at) { return at.isCut() && at.f == 0; }},
      {"{h} is as much as {R}: the plane {E} touches the sphere in one point, {M}.", isTouched},
      {"{h} is more than {R}: the plane {E} misses the sphere.", isMissed},
      {"Zero: the centre {c} lies in the plane.",
       [](const PlaneAtSphere &at) { return at.isThroughCenter(); }},
      {"Not zero: the centre {c} lies beside the plane.", [](const PlaneAtSphere &at) { return at.f != 0; }},
      {"How far the centre is from the plane.", areBoth},
      {"The foot of {c}: the centre of the circle.", isCut},
      {"The foot of {c}: the point where the plane touches.", isTouched},
      {"The foot of {c}: the plane's point nearest to the sphere.", isMissed},
      {"Positive: by Pythagoras this is the square of the circle's radius.", isCut},
      {"Zero: the circle has shrunk to one point.", isTouched},
      {"Negative: it has no real square root, so there is no circle.", isMissed},
      {"The radius of the circle.", isCut},
  });
}

} // namespace claims
} // namespace halfspace::test
