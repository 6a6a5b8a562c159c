#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct PlaneAndPoint {
  explicit PlaneAndPoint(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), Q(objectAs<PointObject>(*objects[1])->at),
        f(product(E.normal, Q) - product(E.normal, E.point)) {}

  bool isPlane() const { return !vanishes(E.normal); }

  PlaneObject E;
  ExactVec3 Q;
  Rational f;
};

bool isPlane(const PlaneAndPoint &at) { return at.isPlane(); }
bool isApart(const PlaneAndPoint &at) { return at.isPlane() && at.f != 0; }
bool isInPlane(const PlaneAndPoint &at) { return at.isPlane() && at.f == 0; }

} // namespace

namespace claims {

Claims parallel_plane() {
  return claimsAbout<PlaneAndPoint>({
      {"{F} goes through {Q} and is parallel to {E}: {distance} from plane to plane.", isApart},
      {"{Q} lies in {E}: the plane through {Q} with the same normal is {E} itself.", isInPlane},
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const PlaneAndPoint &at) { return !at.isPlane(); }},
      {"distance", always}, // in {distance}
      {"Parallel planes have a normal in common.", isPlane},
      {"So that {Q} fulfils the equation.", isPlane},
      {"A point P = (x, y, z) lies in {plane} exactly when it makes this 0.", isPlane},
      {"{Q} put into the equation of {E}: not 0, so {E} does not go through {Q}.", isApart},
      {"{Q} put into the equation of {E}: 0, so {E} goes through {Q}.", isInPlane},
      {"From {Q} straight along {E.n}: the point of {E} that is nearest to {Q}.", isPlane},
      {"All points of {F} are as far from {E} as {Q} is.", isPlane},
  });
}

} // namespace claims
} // namespace halfspace::test
