#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct OnePlane {
  explicit OnePlane(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), nn(product(E.normal, E.normal)) {}

  PlaneObject E;
  Rational nn;
};

bool isPlane(const OnePlane &at) { return at.nn != 0; }
bool isNone(const OnePlane &at) { return at.nn == 0; }

/// Whether a text tells a point by decimals, because its fractions are long.
bool isRounded(const std::string &told) { return told.find("≈") != std::string::npos; }

/// Of the point that a sentence tells as `P₁ = (1, −2, 1/3)`.
ExactVec3 pointIn(const std::string &told) {
  const std::string minus = "−";
  std::array<Rational, 3> coordinates;
  auto from = told.find('(') + 1;
  for (Rational &coordinate : coordinates) {
    const auto to = told.find_first_of(",)", from);
    const bool isNegative = told.compare(from, minus.size(), minus) == 0;
    const auto digits = from + (isNegative ? minus.size() : 0);
    const Rational size = parseRational(told.substr(digits, to - digits)).value();
    coordinate = isNegative ? Rational(-size) : size;
    from = told.find_first_not_of(", ", to);
  }
  return {coordinates[0], coordinates[1], coordinates[2]};
}

bool isAnotherPoint(const OnePlane &at, const Said &said) {
  if (isRounded(said.at("point")))
    return isPlane(at);
  const ExactVec3 way = pointIn(said.at("point")) - at.E.point;
  return !vanishes(way) && product(at.E.normal, way) == 0;
}

} // namespace

namespace claims {

Claims plane_implicit() {
  return claimsAbout<OnePlane>({
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.", isNone},
      {"A point P lies in the plane exactly when {equation}.", isPlane},
      {"P lies in the plane exactly when this dot product is zero.", isPlane},
      {"This dot product is zero for every P, so it tells no plane.", isNone},
      {"The numbers put in, with P = (x, y, z).", always},
      {"Multiplied out, coordinate by coordinate.", always},
      {"Collected: the numbers before x, y and z are the coordinates of {n}, and the constant is −{n}·{P0}.",
       always},
      {"{point}, another point of the plane, gives the same number as {P0}.", isAnotherPoint},
      {"|{n}| is 1: the equation is normalized already, so its right side gives distances.",
       [](const OnePlane &at) { return at.nn == 1; }},
      {"Divided by the length of the normal, {length}: the normalized form. The plane is the same, and the "
       "right side now gives distances.",
       [](const OnePlane &at) { return at.nn != 0 && at.nn != 1; }},
      {"Twice the normal doubles every number and changes nothing: the same points make it zero.", isPlane},
  });
}

} // namespace claims
} // namespace halfspace::test
