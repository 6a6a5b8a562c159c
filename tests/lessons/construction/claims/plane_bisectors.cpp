#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct TwoPlanes {
  explicit TwoPlanes(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), F(objectAs<PlaneObject>(*objects[1]).value()) {}

  bool arePlanes() const { return !vanishes(E.normal) && !vanishes(F.normal); }
  bool cross() const { return !vanishes(perpendicular(E.normal, F.normal)); }
  bool areAlong() const { return arePlanes() && !cross(); }
  bool isPointInBoth() const { return product(F.normal, ExactVec3(E.point - F.point)) == 0; }
  bool areParallel() const { return areAlong() && !isPointInBoth(); }
  /// The product of the lengths is as rational as their ratio.
  bool hasRoots() const {
    return !Surd::root(Rational(product(E.normal, E.normal) * product(F.normal, F.normal))).isRational();
  }

  PlaneObject E, F;
};

bool arePlanes(const TwoPlanes &at) { return at.arePlanes(); }
bool cross(const TwoPlanes &at) { return at.cross(); }
bool areParallel(const TwoPlanes &at) { return at.areParallel(); }
bool isAnyHalved(const TwoPlanes &at) { return at.cross() || at.areParallel(); }

} // namespace

namespace claims {

Claims plane_bisectors() {
  return claimsAbout<TwoPlanes>({
      {"{G} and {H} halve the angles of {E} and {F}: they have all points that are equally far from both.",
       [](const TwoPlanes &at) { return at.cross() && !at.hasRoots(); }},
      {"{G} and {H} halve the angles of {E} and {F}. Their equations have roots, because {k} has one: so "
       "they "
       "are only drawn, and are no objects of the scene.",
       [](const TwoPlanes &at) { return at.cross() && at.hasRoots(); }},
      {"{E} and {F} are parallel: the only points that are equally far from both are those of {G}, halfway "
       "between them.",
       areParallel},
      {"{E} and {F} are the same plane: every point is equally far from both, and there is no angle to "
       "halve.",
       [](const TwoPlanes &at) { return at.areAlong() && at.isPointInBoth(); }},
      {"The normal {zero} is the zero vector: it points nowhere, so there is no plane.",
       [](const TwoPlanes &at, const Said &said) {
         return vanishes(said.at("zero") == "n_E" ? at.E.normal : at.F.normal);
       }},
      {"The constant d of {plane}: its equation is n·P + d = 0.", arePlanes},
      {"So many times {E.n} is as long as {F.n}. Then k times the equation of {E} measures distances in the "
       "same unit as that of {F}.",
       arePlanes},
      {"{E} and {F} meet in a line that goes this way.", cross},
      {"Halfway from {E.P0} to {F.P0}: equally far from both planes.", areParallel},
      {"A point of both planes, the nearest one to the origin: it is 0 away from both.", cross},
      {"The normal of {plane}, from two vectors of one length.", isAnyHalved},
      {"The constant, from those of {E} and {F} likewise.", isAnyHalved},
      {"A point P = (x, y, z) lies in {plane} exactly when it makes this 0.", isAnyHalved},
      {"0: {G} and {H} are perpendicular to each other, whatever the angle of {E} and {F} is.", cross},
  });
}

} // namespace claims
} // namespace halfspace::test
