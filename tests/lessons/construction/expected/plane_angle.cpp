#include "tests/lessons/construction/expected/acute_angle_tools.h"

namespace halfspace::test {
namespace {

std::string caseOf(const ExactVec3 &a, const ExactVec3 &b) {
  if (vanishes(perpendicular(a, b)))
    return "parallel";
  return product(a, b) == 0 ? "perpendicular" : "oblique";
}

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto F = objectAs<PlaneObject>(*objects[1]).value();
  Recomputed expected;
  expected.names = {{"\\vec n_E", quantity(E.normal)},
                    {"\\vec n_F", quantity(F.normal)},
                    {"P_{0,E}", quantity(E.point)},
                    {"P_{0,F}", quantity(F.point)}};
  if (vanishes(E.normal))
    expected.vanished.insert("E.n");
  if (vanishes(F.normal))
    expected.vanished.insert("F.n");
  expected.degenerate = !expected.vanished.empty();
  expected.caseName = expected.degenerate ? "zero-normal" : caseOf(E.normal, F.normal);
  if (!expected.degenerate)
    addAcute(expected, "cosine", "\\cos\\varphi", E.normal, F.normal);
  if (expected.caseName == "parallel")
    expected.vanished.insert("it.phi");
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  return acuteWrongAnswers(objectAs<PlaneObject>(*objects[0])->normal,
                           objectAs<PlaneObject>(*objects[1])->normal, "length-E", "length-F");
}

} // namespace

namespace expected {

Expected plane_angle() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.3};
}

} // namespace expected
} // namespace halfspace::test
