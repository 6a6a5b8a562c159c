#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  const Rational f = product(E.normal, Q) - product(E.normal, E.point);
  const Rational square = product(E.normal, E.normal);
  const ExactVec3 w = Q - E.point;
  Recomputed expected;
  expected.values["f"] = number(f);
  expected.names = {{"\\vec n", quantity(E.normal)},
                    {"P_0", quantity(E.point)},
                    {"Q", quantity(Q)},
                    {"f(Q)", quantity(f)},
                    {"\\vec w", quantity(w)}};
  expected.degenerate = square == 0;
  if (square == 0) {
    expected.caseName = "zero-normal";
    expected.vanished = {"E.n"};
    return expected;
  }
  expected.caseName = f > 0 ? "positive" : f < 0 ? "negative" : "on";
  if (f == 0)
    expected.vanished = {"it.distance"};
  const ExactVec3 foot = footOf(Q, E);
  expected.values["side"] = expected.caseName;
  expected.values["signed_distance"] = SignedSquares{signedSquare(f, square)};
  expected.values["foot"] = numbers(foot);
  const Rational after = product(E.normal, ExactVec3(Q + ExactVec3(1, 0, 0))) - product(E.normal, E.point);
  expected.values["along_x"] = std::string(after * after < f * f   ? "nearer"
                                           : after * after > f * f ? "farther"
                                                                   : "same");
  expected.values["steps"] = number(Rational(f / square));
  // Back from Q by what leads to its foot, seen from P0.
  expected.names["M"] = quantity(ExactVec3(E.point + (Q - foot)));
  expected.names["F"] = quantity(foot);
  expected.names["\\operatorname{dist}"] = quantityOverRoot(f, square);
  if (vanishes(w))
    return expected;
  const Rational both = square * product(w, w);
  expected.values["cos_angle"] = SignedSquares{signedSquare(f, both)};
  expected.names["\\cos\\theta"] = quantityOverRoot(f, both);
  return expected;
}

void addDistance(std::vector<WrongAnswer> &all, const ExactVec3 &n, const Rational &f) {
  const Rational square = times(n, n);
  Line line("distance", Surd::root(square, Rational(f / square)), all);
  line.add("not divided", f);
  line.add("not divided, the sign lost", Rational(-f));
  line.addOverRoot("the sign lost", Rational(-f), square);
  line.addRatio("divided by n·n", f, square);
  line.addRatio("divided by n·n, the sign lost", Rational(-f), square);
  line.addRatio("divided by the coordinates' sum", f, coordinateSum(n));
  line.add("multiplied instead of divided", Surd::root(square, f));
  line.add("only the length", Surd::root(square));
  if (f != 0)
    line.add("upside down", Surd::root(square, Rational(1 / f)));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  const ExactVec3 w = Q - E.point;
  const Rational f = times(E.normal, w);
  std::vector<WrongAnswer> all;
  Line line("f", f, all);
  addSlips(line, differenceSlips(E.normal, Q, E.point));
  if (times(E.normal, E.normal) == 0)
    return all;
  line.addOverRoot("divided by the length already", f, times(E.normal, E.normal));
  addLength(all, "length", E.normal);
  addDistance(all, E.normal, f);
  if (times(w, w) != 0)
    addCosine(all, E.normal, w);
  return all;
}

} // namespace

namespace expected {

Expected signed_distance() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.48};
}

} // namespace expected
} // namespace halfspace::test
