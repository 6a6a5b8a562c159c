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
  Recomputed expected;
  expected.values["f"] = number(f);
  expected.names = {
      {"\\vec n", quantity(E.normal)}, {"P_0", quantity(E.point)}, {"Q", quantity(Q)}, {"f(Q)", quantity(f)}};
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
  const ExactVec3 image = foot + ExactVec3(foot - Q);
  expected.values["signed_distance"] = SignedSquares{signedSquare(f, square)};
  expected.values["foot"] = numbers(foot);
  expected.values["image"] = numbers(image);
  expected.names["F"] = quantity(foot);
  expected.names["S"] = quantity(image);
  expected.names["\\operatorname{dist}"] = quantityOverRoot(f, square);
  return expected;
}

void addImage(std::vector<WrongAnswer> &all, const ExactVec3 &Q, const ExactVec3 &foot, const ExactVec3 &n,
              const Rational &f) {
  const ExactVec3 down = foot - Q;
  const ExactVec3 right = foot + down;
  const auto add = [&](const char *how, const ExactVec3 &wrong) {
    addVector(all, "image", how, wrong, right);
  };
  add("the foot", foot);
  add("away from the plane", Q - down * Rational(2));
  add("as if n had the length 1", Q - n * Rational(2 * f));
  add("mirrored in the origin", -Q);
  add("the point itself", Q);
  add("only the way", down * Rational(2));
  for (int i = 0; i < 3; ++i) {
    ExactVec3 wrong = right;
    wrong[i] = Q[i];
    add("one coordinate left as it was", wrong);
    wrong[i] = -Q[i];
    add("one coordinate mirrored in the origin", wrong);
  }
}

void addDistance(std::vector<WrongAnswer> &all, const ExactVec3 &n, const Rational &f) {
  const Rational square = times(n, n);
  Line line("distance", Surd::root(square, Rational(f / square)), all);
  line.add("not divided", f);
  line.addOverRoot("the sign lost", Rational(-f), square);
  line.addRatio("divided by n·n", f, square);
  line.add("only the length", Surd::root(square));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  const Rational f = times(E.normal, ExactVec3(Q - E.point));
  std::vector<WrongAnswer> all;
  Line line("f", f, all);
  addSlips(line, differenceSlips(E.normal, Q, E.point));
  if (times(E.normal, E.normal) == 0)
    return all;
  addDistance(all, E.normal, f);
  addImage(all, Q, footOf(Q, E), E.normal, f);
  return all;
}

} // namespace

namespace expected {

Expected mirror_point() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
