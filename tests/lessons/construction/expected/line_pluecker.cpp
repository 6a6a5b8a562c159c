#include "lessons/object/kinds/line.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// The point nearest to the origin: from A back along the line as far as A reaches along it.
ExactVec3 nearestOf(const LineObject &g) {
  const Rational along = product(g.point, g.direction) / product(g.direction, g.direction);
  return g.point - g.direction * along;
}

Recomputed recompute(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  Recomputed expected;
  expected.names = {{"A", quantity(g.point)}, {"\\vec v", quantity(g.direction)}};
  expected.caseName = "line";
  expected.degenerate = vanishes(g.direction);
  if (expected.degenerate) {
    expected.caseName = "zero-direction";
    expected.vanished.insert("g.v");
    return expected;
  }
  const ExactVec3 nearest = nearestOf(g);
  // By the nearest point, where the program takes A.
  const ExactVec3 moment = perpendicular(nearest, g.direction);
  const Rational square = product(nearest, nearest);
  if (vanishes(nearest))
    expected.vanished = {"it.m", "it.dist"};
  expected.values = {{"direction", numbers(g.direction)},
                     {"moment", numbers(moment)},
                     {"relation", number(0)},
                     {"through_origin", vanishes(nearest) ? "true" : "false"},
                     {"nearest_to_origin", numbers(nearest)},
                     {"origin_distance", SignedSquares{square}}};
  expected.names["\\vec m"] = quantity(moment);
  expected.names["N"] = quantity(nearest);
  expected.names["\\operatorname{dist}_g"] =
      square == 0 ? quantity(Rational(0)) : quantityOverRoot(square, square);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  std::vector<WrongAnswer> all;
  const Rational vv = times(g.direction, g.direction);
  if (vv == 0)
    return all;
  const ExactVec3 moment = perpendicular(g.point, g.direction);
  const Rational mm = times(moment, moment);
  addProduct(all, "relation", g.direction, moment);
  Line distance("distance", Surd::root(Rational(mm / vv)), all);
  distance.add("not divided", Surd::root(mm));
  distance.add("only the denominator", Surd::root(vv));
  distance.add("the root forgotten", Rational(mm / vv));
  distance.add("the root forgotten above", Surd::root(vv, Rational(mm / vv)));
  distance.add("divided by the square", Surd::root(mm, Rational(1 / vv)));
  distance.addOverRoot("upside down", vv, Rational(mm * vv));
  return all;
}

} // namespace

namespace expected {

Expected line_pluecker() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
