#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/made_plane.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  Recomputed expected;
  expected.names = {{"\\vec n_E", quantity(E.normal)}, {"P_{0,E}", quantity(E.point)}, {"Q", quantity(Q)}};
  expected.degenerate = vanishes(E.normal);
  if (expected.degenerate) {
    expected.caseName = "zero-normal";
    expected.vanished.insert("E.n");
    return expected;
  }
  expectMadePlane({Q, E.normal}, "F", expected);
  const Rational f = product(E.normal, Q) - product(E.normal, E.point);
  const Rational square = product(E.normal, E.normal);
  expected.caseName = f == 0 ? "same" : "parallel";
  if (f == 0)
    expected.vanished.insert("it.distance");
  const ExactVec3 foot = footOf(Q, E);
  expected.values["f"] = number(f);
  expected.values["foot"] = numbers(foot);
  expected.values["distance"] = SignedSquares{Rational(f * f / square)};
  expected.names["f(Q)"] = quantity(f);
  expected.names["H"] = quantity(foot);
  expected.names["\\operatorname{dist}"] = quantityOverRoot(abs(f), square);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  std::vector<WrongAnswer> all;
  if (vanishes(E.normal))
    return all;
  addPlaneEquation(all, {Q, E.normal});
  const Rational f = times(E.normal, ExactVec3(Q - E.point));
  const Rational square = times(E.normal, E.normal);
  Line height("f", f, all);
  addSlips(height, differenceSlips(E.normal, Q, E.point));
  Line distance("distance", Surd::root(square, Rational(abs(f) / square)), all);
  distance.add("not divided", abs(f));
  distance.addRatio("divided by n·n", abs(f), square);
  distance.addOverRoot("the sign kept", f, square);
  return all;
}

} // namespace

namespace expected {

Expected parallel_plane() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
