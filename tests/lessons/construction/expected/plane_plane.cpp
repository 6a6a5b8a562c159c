#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto F = objectAs<PlaneObject>(*objects[1]).value();
  const Rational d1 = -product(E.normal, E.point);
  const Rational d2 = -product(F.normal, F.point);
  Recomputed expected;
  expected.names = {{"\\vec n_E", quantity(E.normal)},
                    {"\\vec n_F", quantity(F.normal)},
                    {"P_{0,E}", quantity(E.point)},
                    {"P_{0,F}", quantity(F.point)},
                    {"d_E", quantity(d1)},
                    {"d_F", quantity(d2)}};
  expected.degenerate = vanishes(E.normal) || vanishes(F.normal);
  if (vanishes(E.normal))
    expected.vanished.insert("E.n");
  if (vanishes(F.normal))
    expected.vanished.insert("F.n");
  if (expected.degenerate) {
    expected.caseName = "zero-normal";
    return expected;
  }
  const Rational f = product(E.normal, F.normal);
  const Rational squares = product(E.normal, E.normal) * product(F.normal, F.normal);
  expected.values["cos_angle"] = SignedSquares{signedSquare(f, squares)};
  expected.names["\\cos\\varphi"] = quantityOverRoot(f, squares);
  const ExactVec3 direction = perpendicular(E.normal, F.normal);
  expected.names["\\vec v"] = quantity(direction);
  if (f * f == squares) { // the normals are parallel
    const bool isSame = product(E.normal, ExactVec3(F.point - E.point)) == 0;
    expected.caseName = isSame ? "coincident" : "parallel";
    expected.vanished.insert("it.g.v");
    expected.vanished.insert("it.phi");
    return expected;
  }
  expected.caseName = "line";
  // The point as a sum of the two normals that both equations fit, by Cramer's rule.
  const Rational ee = product(E.normal, E.normal);
  const Rational ff = product(F.normal, F.normal);
  const Rational whole = ee * ff - f * f;
  const ExactVec3 point =
      E.normal * Rational((f * d2 - ff * d1) / whole) + F.normal * Rational((f * d1 - ee * d2) / whole);
  const ExactVec3 moment = perpendicular(point, direction);
  expected.values["direction"] = numbers(direction);
  expected.values["moment"] = numbers(moment);
  expected.values["point"] = numbers(point);
  expected.names["\\vec m"] = quantity(moment);
  expected.names["A"] = quantity(point);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto F = objectAs<PlaneObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  if (times(E.normal, E.normal) == 0 || times(F.normal, F.normal) == 0)
    return all;
  for (const auto &[id, plane] : {std::pair("d1", E), std::pair("d2", F)}) {
    const Rational product = times(plane.normal, plane.point);
    Line line(id, Rational(-product), all);
    line.add("the minus forgotten", product);
    for (const auto &[how, value] : dotSlips(plane.normal, plane.point))
      line.add(how, Rational(-value));
  }
  addCosine(all, E.normal, F.normal, "angle");
  return all;
}

} // namespace

namespace expected {

Expected plane_plane() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
