#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/made_plane.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const ExactVec3 A = objectAs<PointObject>(*objects[0])->at;
  const ExactVec3 B = objectAs<PointObject>(*objects[1])->at;
  Recomputed expected;
  expected.names = {{"A", quantity(A)}, {"B", quantity(B)}};
  expected.degenerate = vanishes(ExactVec3(A - B));
  if (expected.degenerate) {
    expected.caseName = "same-point";
    return expected;
  }
  expected.caseName = "plane";
  const ExactVec3 middle = A + ExactVec3(B - A) * Rational(1, 2);
  expectMadePlane({middle, ExactVec3(B - A)}, "", expected);
  const Rational square = product(ExactVec3(middle - A), ExactVec3(middle - A));
  expected.values["middle"] = numbers(middle);
  expected.values["distance"] = SignedSquares{square};
  expected.names["\\operatorname{dist}"] = quantityOverRoot(square, square);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const ExactVec3 A = objectAs<PointObject>(*objects[0])->at;
  const ExactVec3 B = objectAs<PointObject>(*objects[1])->at;
  std::vector<WrongAnswer> all;
  if (A == B)
    return all;
  const ExactVec3 way = B - A;
  const ExactVec3 middle = (A + B) / Rational(2);
  addVector(all, "normal", "the other way round", A - B, way);
  addVector(all, "normal", "added", A + B, way);
  addVector(all, "middle", "half of the way", way / Rational(2), middle);
  addVector(all, "middle", "not halved", A + B, middle);
  addPlaneEquation(all, {middle, way});
  const Rational square = times(way, way);
  Line distance("distance", Surd::root(square, Rational(1, 2)), all);
  distance.add("not halved", Surd::root(square));
  distance.add("the root forgotten", Rational(square / 2));
  distance.add("doubled", Surd::root(square, 2));
  return all;
}

} // namespace

namespace expected {

Expected perpendicular_bisector() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
