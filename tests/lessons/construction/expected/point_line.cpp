#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const ExactVec3 Q = objectAs<PointObject>(*objects[0])->at;
  const auto g = objectAs<LineObject>(*objects[1]).value();
  const ExactVec3 w = Q - g.point;
  Recomputed expected;
  expected.names = {{"Q", quantity(Q)},
                    {"A", quantity(g.point)},
                    {"\\vec v", quantity(g.direction)},
                    {"\\vec w", quantity(w)}};
  if (vanishes(w))
    expected.vanished.insert("it.w");
  expected.degenerate = vanishes(g.direction);
  if (expected.degenerate) {
    expected.caseName = "zero-direction";
    expected.vanished.insert("g.v");
    return expected;
  }
  const Rational square = product(g.direction, g.direction);
  const Rational t = product(w, g.direction) / square;
  const ExactVec3 across = perpendicular(w, g.direction);
  const ExactVec3 foot = g.point + g.direction * t;
  expected.caseName = vanishes(across) ? "on" : "off";
  if (vanishes(across))
    expected.vanished.insert("it.h");
  expected.values = {{"t", number(t)},
                     {"foot", numbers(foot)},
                     {"distance", SignedSquares{Rational(product(across, across) / square)}}};
  expected.names["t"] = quantity(t);
  expected.names["F"] = quantity(foot);
  expected.names["\\vec h"] = quantity(ExactVec3(Q - foot));
  expected.names["\\operatorname{dist}"] =
      quantityOverRoot(product(across, across) / square, product(across, across) / square);
  if (vanishes(across))
    expected.names["\\operatorname{dist}"] = quantity(Rational(0));
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const ExactVec3 Q = objectAs<PointObject>(*objects[0])->at;
  const auto g = objectAs<LineObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  const Rational square = times(g.direction, g.direction);
  if (square == 0)
    return all;
  const ExactVec3 w = Q - g.point;
  const Rational top = times(w, g.direction);
  Line t("t", Rational(top / square), all);
  addFraction(t, top, square);
  t.addOverRoot("divided by the length", top, square);
  for (const auto &[how, value] : dotSlips(w, g.direction))
    t.addRatio(how, value, square);
  addLength(all, "distance", ExactVec3(w - g.direction * Rational(top / square)));
  return all;
}

} // namespace

namespace expected {

Expected point_line() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
