// Two planes, as several constructions look at them.
#pragma once

#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/claims/said_angle.h"

namespace halfspace::test {

struct TwoPlanes {
  explicit TwoPlanes(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), F(objectAs<PlaneObject>(*objects[1]).value()),
        nn(product(E.normal, F.normal)) {}

  bool arePlanes() const { return !vanishes(E.normal) && !vanishes(F.normal); }
  bool meetInLine() const { return !vanishes(perpendicular(E.normal, F.normal)); }
  bool haveSameNormals() const { return arePlanes() && !meetInLine(); }
  bool isPointInBoth() const { return product(F.normal, ExactVec3(E.point - F.point)) == 0; }
  bool passThroughOrigin() const {
    return product(E.normal, E.point) == 0 && product(F.normal, F.point) == 0;
  }
  bool isAngle(const std::string &told) const { return isAngleBetween(E.normal, F.normal, told); }

  PlaneObject E, F;
  Rational nn;
};

inline bool arePlanes(const TwoPlanes &at) { return at.arePlanes(); }
inline bool meetInLine(const TwoPlanes &at) { return at.meetInLine(); }
inline bool areParallel(const TwoPlanes &at) { return at.haveSameNormals() && !at.isPointInBoth(); }
inline bool areSame(const TwoPlanes &at) { return at.haveSameNormals() && at.isPointInBoth(); }

/// Of the case of planes without a normal.
[[nodiscard]] inline Claims zeroNormalsClaims() {
  return claimsAbout<TwoPlanes>({
      {"The normal {zero} is the zero vector: it points nowhere, so there is no plane.",
       [](const TwoPlanes &at, const Said &said) {
         return vanishes(said.at("zero") == "n_E" ? at.E.normal : at.F.normal);
       }},
  });
}

} // namespace halfspace::test
