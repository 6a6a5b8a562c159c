#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/made_plane.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  Recomputed expected;
  expected.names = {{"A", quantity(g.point)}, {"\\vec v", quantity(g.direction)}, {"Q", quantity(Q)}};
  expected.degenerate = vanishes(g.direction);
  if (expected.degenerate) {
    expected.caseName = "zero-direction";
    expected.vanished.insert("g.v");
    return expected;
  }
  expectMadePlane({Q, g.direction}, "", expected);
  const Rational t =
      (product(g.direction, Q) - product(g.direction, g.point)) / product(g.direction, g.direction);
  const ExactVec3 point = g.point + g.direction * t;
  expected.caseName = vanishes(perpendicular(ExactVec3(Q - g.point), g.direction)) ? "on" : "off";
  expected.values["t"] = number(t);
  expected.values["point"] = numbers(point);
  expected.names["t"] = quantity(t);
  expected.names["S"] = quantity(point);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  std::vector<WrongAnswer> all;
  if (vanishes(g.direction))
    return all;
  addPlaneEquation(all, {Q, g.direction});
  const Rational top = times(g.direction, ExactVec3(Q - g.point));
  const Rational bottom = times(g.direction, g.direction);
  Line t("t", Rational(top / bottom), all);
  addFraction(t, top, bottom);
  t.addOverRoot("divided by the length", top, bottom);
  addPointOnRay(all, "point", g.point, Rational(top / bottom), g.direction);
  return all;
}

} // namespace

namespace expected {

Expected perpendicular_plane() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.35};
}

} // namespace expected
} // namespace halfspace::test
