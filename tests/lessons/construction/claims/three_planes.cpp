#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct AllThree {
  explicit AllThree(Objects objects)
      : planes{objectAs<PlaneObject>(*objects[0]).value(), objectAs<PlaneObject>(*objects[1]).value(),
               objectAs<PlaneObject>(*objects[2]).value()},
        det(determinant(planes[0].normal, planes[1].normal, planes[2].normal)) {}

  bool arePlanes() const {
    return std::none_of(planes.begin(), planes.end(),
                        [](const PlaneObject &plane) { return vanishes(plane.normal); });
  }
  bool areAlong(std::size_t one, std::size_t other) const {
    return arePlanes() && vanishes(perpendicular(planes.at(one).normal, planes.at(other).normal));
  }
  bool areSame(std::size_t one, std::size_t other) const {
    return areAlong(one, other) && has(planes.at(one), planes.at(other).point);
  }
  bool areParallel(std::size_t one, std::size_t other) const {
    return areAlong(one, other) && !areSame(one, other);
  }
  bool areAllAlong() const { return areAlong(0, 1) && areAlong(0, 2); }
  /// No two have their normals along one line.
  bool areAllAcross() const { return arePlanes() && !areAlong(0, 1) && !areAlong(1, 2) && !areAlong(0, 2); }
  bool meetInPoint() const { return det != 0; }
  /// Without a single common point, F and one of the others whose normal is not along its own have a line:
  /// all three share it where a point of it lies in the last one.
  bool meetInLine() const {
    if (!arePlanes() || meetInPoint() || areAllAlong())
      return false;
    const std::size_t other = areAlong(0, 1) ? 2 : 0;
    return has(planes.at(2 - other), pointOfBoth(other, 1));
  }

  std::array<PlaneObject, 3> planes;
  Rational det;

private:
  static bool has(const PlaneObject &plane, const ExactVec3 &point) {
    return product(plane.normal, ExactVec3(point - plane.point)) == 0;
  }
  /// In the first plane, from its point on, until it lies in the second one too.
  ExactVec3 pointOfBoth(std::size_t first, std::size_t second) const {
    const auto &[point, normal] = planes.at(first);
    const auto &[otherPoint, otherNormal] = planes.at(second);
    const ExactVec3 way = perpendicular(normal, perpendicular(normal, otherNormal));
    return point +
           way * Rational(product(otherNormal, ExactVec3(otherPoint - point)) / product(otherNormal, way));
  }
};

/// The planes that a sentence names.
std::size_t placeOf(const Said &said, const std::string &place) {
  return std::string("EFG").find(said.at(place));
}
bool areAlong(const AllThree &at, const Said &said) {
  return at.areAlong(placeOf(said, "first"), placeOf(said, "second"));
}

bool arePlanes(const AllThree &at) { return at.arePlanes(); }
bool meetInPoint(const AllThree &at) { return at.meetInPoint(); }
bool meetInLine(const AllThree &at) { return at.meetInLine(); }
bool areSame(const AllThree &at) { return at.areSame(0, 1) && at.areSame(0, 2); }
bool arePrism(const AllThree &at) { return at.areAllAcross() && !at.meetInPoint() && !at.meetInLine(); }

} // namespace

namespace claims {

Claims three_planes() {
  return claimsAbout<AllThree>({
      {"{D} is not 0: the planes {E}, {F} and {G} have a single point in common, {point}.", meetInPoint},
      {"{first} and {second} are the same plane, which {third} meets in a line: each point of the line lies "
       "in all three.",
       [](const AllThree &at, const Said &said) {
         return at.meetInLine() && at.areSame(placeOf(said, "first"), placeOf(said, "second")) &&
                !at.areAlong(placeOf(said, "first"), placeOf(said, "third"));
       }},
      {"D = 0 and X is the zero vector: {E}, {F} and {G} all go through one line.", meetInLine},
      {"D = 0 and X is not the zero vector: {E}, {F} and {G} meet two by two in three parallel lines, and no "
       "point lies in all three.",
       arePrism},
      {"{first} and {second} are parallel and share no point, so no point lies in all three planes.",
       [](const AllThree &at, const Said &said) {
         return at.areParallel(placeOf(said, "first"), placeOf(said, "second"));
       }},
      {"{E}, {F} and {G} are the same plane: each of its points lies in all three.", areSame},
      {"The normal {zero} is the zero vector: it points nowhere, so there is no plane.",
       [](const AllThree &at, const Said &said) {
         return vanishes(at.planes.at(std::string("EFG").find(said.at("zero").back())).normal);
       }},
      {"The constant d of {plane}: its equation is n·P + d = 0.", arePlanes},
      {"The zero vector: the normals of {first} and {second} lie along one line.", areAlong},
      {"{first} and {second} meet in a line that goes this way.",
       [](const AllThree &at, const Said &said) { return at.arePlanes() && !areAlong(at, said); }},
      {"The determinant of the normals. It is not 0, so no direction runs along all three planes.",
       meetInPoint},
      {"The determinant of the normals. It is 0: a direction runs along all three planes, so they share more "
       "than one point, or none.",
       [](const AllThree &at) { return at.arePlanes() && !at.meetInPoint(); }},
      {"The common point, times D.", meetInPoint},
      {"The zero vector, and D = 0: the three equations hold along a whole line.", meetInLine},
      {"No point fulfils all three equations: only the direction of the parallel lines is left.", arePrism},
      {"No point fulfils all three equations: only a direction along all three planes is left.",
       [](const AllThree &at) {
         return at.arePlanes() && !at.areAllAlong() && !at.areAllAcross() && !at.meetInLine();
       }},
      {"The zero vector, because all three cross products are. It does not tell whether the planes are the "
       "same.",
       [](const AllThree &at) { return at.areAllAlong(); }},
      {"Divided by D: the common point.", meetInPoint},
  });
}

} // namespace claims
} // namespace halfspace::test
