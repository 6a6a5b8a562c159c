#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/claims/said_angle.h"

namespace halfspace::test {
namespace {

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

bool arePlanes(const TwoPlanes &at) { return at.arePlanes(); }
bool meetInLine(const TwoPlanes &at) { return at.meetInLine(); }

} // namespace

namespace claims {

Claims plane_plane() {
  return claimsAbout<TwoPlanes>({
      {"The planes {E} and {F} meet in the line {g}.", meetInLine},
      {"The normals are multiples of each other, and no point lies in both planes: {E} and {F} are parallel.",
       [](const TwoPlanes &at) { return at.haveSameNormals() && !at.isPointInBoth(); }},
      {"{E} and {F} are the same plane: every point of one lies in the other.",
       [](const TwoPlanes &at) { return at.haveSameNormals() && at.isPointInBoth(); }},
      {"The normal {zero} is the zero vector: it points nowhere, so there is no plane.",
       [](const TwoPlanes &at, const Said &said) {
         return vanishes(said.at("zero") == "n_E" ? at.E.normal : at.F.normal);
       }},
      {"The constant d of {plane}: its equation is n·P + d = 0.", arePlanes},
      {"The line lies in both planes, so it is perpendicular to both normals.", meetInLine},
      {"The cross product is the zero vector: the normals lie along the same line, and the planes share no "
       "single line.",
       [](const TwoPlanes &at) { return at.haveSameNormals(); }},
      {"The moment P × {v} is the same for every point P of the line. The two equations give it without "
       "knowing any point.",
       meetInLine},
      {"The moment is zero: the line goes through the origin, which is its nearest point.",
       [](const TwoPlanes &at) { return at.meetInLine() && at.passThroughOrigin(); }},
      {"The point of the line that is nearest to the origin.", meetInLine},
      {"φ{degrees}°: the normals lie along the same line.",
       [](const TwoPlanes &at, const Said &said) {
         return at.haveSameNormals() && at.isAngle(said.at("degrees"));
       }},
      {"φ{degrees}° is the angle between the normals, and so between the planes.",
       [](const TwoPlanes &at, const Said &said) {
         return at.meetInLine() && at.nn >= 0 && at.isAngle(said.at("degrees"));
       }},
      {"φ{degrees}° is the angle between the normals. The planes meet at 180° − φ.",
       [](const TwoPlanes &at, const Said &said) {
         return at.meetInLine() && at.nn < 0 && at.isAngle(said.at("degrees"));
       }},
  });
}

} // namespace claims
} // namespace halfspace::test
