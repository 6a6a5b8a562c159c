#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

std::string caseOf(const LineObject &g, const PlaneObject &E) {
  if (vanishes(E.normal))
    return "zero-normal";
  if (vanishes(g.direction))
    return "not-a-line";
  if (product(E.normal, g.direction) != 0)
    return "point";
  return product(E.normal, ExactVec3(g.point - E.point)) == 0 ? "in-plane" : "parallel";
}

Recomputed recompute(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const auto E = objectAs<PlaneObject>(*objects[1]).value();
  const Rational weight = product(E.normal, g.direction);
  const Rational missing = product(E.normal, ExactVec3(E.point - g.point));
  // (n·v)A + (n·(P0 − A))v, without a moment.
  const ExactVec3 weighted = g.point * weight + g.direction * missing;
  Recomputed expected;
  expected.caseName = caseOf(g, E);
  expected.degenerate = vanishes(E.normal) || vanishes(g.direction);
  expected.names = {{"A", quantity(g.point)},
                    {"\\vec v", quantity(g.direction)},
                    {"P_0", quantity(E.point)},
                    {"\\vec n", quantity(E.normal)},
                    {"\\vec m", quantity(perpendicular(g.point, g.direction))},
                    {"d", quantity(Rational(-product(E.normal, E.point)))},
                    {"X", quantity(weighted)},
                    {"w", quantity(weight)}};
  if (vanishes(g.direction))
    expected.vanished.insert("g.v");
  if (vanishes(E.normal))
    expected.vanished.insert("E.n");
  if (expected.degenerate)
    return expected;
  SignedSquares homogeneous = numbers(weighted);
  homogeneous.push_back(signedSquare(weight));
  expected.values["homogeneous"] = homogeneous;
  if (expected.caseName != "point")
    return expected;
  const ExactVec3 point = g.point + g.direction * Rational(missing / weight);
  expected.values["point"] = numbers(point);
  expected.names["S"] = quantity(point);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const auto E = objectAs<PlaneObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  if (vanishes(E.normal) || vanishes(g.direction))
    return all;
  const Rational product = times(E.normal, E.point);
  Line constant("d", Rational(-product), all);
  constant.add("the minus forgotten", product);
  for (const auto &[how, value] : dotSlips(E.normal, E.point))
    constant.add(how, Rational(-value));
  addProduct(all, "weight", E.normal, g.direction);
  return all;
}

} // namespace

namespace expected {

Expected line_plane() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
