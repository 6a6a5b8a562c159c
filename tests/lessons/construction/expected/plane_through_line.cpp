#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/made_plane.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  const ExactVec3 w = Q - g.point;
  const ExactVec3 normal = perpendicular(g.direction, w);
  Recomputed expected;
  expected.names = {{"A", quantity(g.point)},
                    {"\\vec v", quantity(g.direction)},
                    {"Q", quantity(Q)},
                    {"\\vec w", quantity(w)},
                    {"\\vec n", quantity(normal)}};
  if (vanishes(w))
    expected.vanished.insert("it.w");
  if (vanishes(g.direction))
    expected.vanished.insert("g.v");
  expected.degenerate = vanishes(normal);
  if (expected.degenerate) {
    expected.caseName = vanishes(g.direction) ? "zero-direction" : "on";
    expected.vanished.insert("it.E.n");
    return expected;
  }
  expected.caseName = "off";
  expectMadePlane({g.point, normal}, "", expected);
  // Without the area: what is left of w across v.
  const Rational along = product(w, g.direction);
  const Rational square = product(w, w) - along * along / product(g.direction, g.direction);
  expected.values["distance"] = SignedSquares{square};
  expected.names["\\operatorname{dist}"] = quantityOverRoot(square, square);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  const ExactVec3 normal = perpendicular(g.direction, ExactVec3(Q - g.point));
  std::vector<WrongAnswer> all;
  if (vanishes(normal))
    return all;
  addVector(all, "w", "the other way round", g.point - Q, Q - g.point);
  addVector(all, "w", "added", g.point + Q, Q - g.point);
  addVector(all, "normal", "the other way round", -normal, normal);
  addPlaneEquation(all, {g.point, normal});
  const Rational area = times(normal, normal);
  const Rational square = times(g.direction, g.direction);
  Line distance("distance", Surd::root(Rational(area / square)), all);
  distance.add("not divided", Surd::root(area));
  distance.addRatio("the roots forgotten", area, square);
  distance.add("multiplied instead of divided", Surd::root(Rational(area * square)));
  return all;
}

} // namespace

namespace expected {

Expected plane_through_line() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
