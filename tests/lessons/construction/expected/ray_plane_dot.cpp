#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 &n = E.normal;
  const Rational atStart = product(n, L.origin) - product(n, E.point);
  const Rational atTip = product(n, ExactVec3(L.origin + L.direction)) - product(n, E.point);
  const Rational slope = atTip - atStart;
  Recomputed expected;
  expected.values = {{"numerator", number(Rational(-atStart))}, {"denominator", number(slope)}};
  expected.names = {{"\\vec n", quantity(n)},    {"\\vec r", quantity(L.direction)},
                    {"P_0", quantity(E.point)},  {"Q", quantity(L.origin)},
                    {"f(Q)", quantity(atStart)}, {"d", quantity(Rational(-product(n, E.point)))}};
  expected.unknowns = {{"t", quantity(somewhere.x)}};
  if (vanishes(n))
    expected.vanished.insert("E.n");
  if (vanishes(L.direction))
    expected.vanished.insert("L.r");
  expected.degenerate = vanishes(n) || vanishes(L.direction);
  if (!vanishes(n)) {
    const Rational square = product(n, n);
    expected.names["\\vec a"] = quantity(ExactVec3(n * Rational(-atStart / square)));
    expected.names["\\vec b"] = quantity(ExactVec3(n * Rational(slope / square)));
  }
  if (vanishes(n) || atStart == 0)
    expected.vanished.insert("it.a");
  if (vanishes(n) || slope == 0)
    expected.vanished.insert("it.b");
  if (slope == 0) {
    expected.caseName = vanishes(n)             ? "zero-normal"
                        : vanishes(L.direction) ? "zero-direction"
                        : atStart == 0          ? "in-plane"
                                                : "parallel";
    return expected;
  }
  // Where the plane's left side, which changes evenly along the ray, becomes zero.
  const Rational t = atStart / (atStart - atTip);
  const ExactVec3 point = L.origin + L.direction * t;
  const ExactVec3 facing = slope > 0 ? ExactVec3(-n) : n;
  const Rational square = product(n, n);
  expected.caseName = t < 0 ? "behind" : "hit";
  expected.values["t"] = number(t);
  expected.values["point"] = numbers(point);
  expected.values["facing_normal"] = normalizedNumbers(facing, square);
  expected.solution = Names{{"t", quantity(t)}};
  expected.names["H"] = quantity(point);
  expected.names["\\vec n_f"] = quantityOverRoot(facing, square);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  Line numerator("numerator", times(E.normal, ExactVec3(E.point - L.origin)), all);
  addSlips(numerator, differenceSlips(E.normal, E.point, L.origin));
  addProduct(all, "denominator", L.direction, E.normal);
  if (times(L.direction, E.normal) != 0)
    addParameter(all, "t", E.normal, E.point, L);
  return all;
}

} // namespace

namespace expected {

Expected ray_plane_dot() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.50};
}

} // namespace expected
} // namespace halfspace::test
