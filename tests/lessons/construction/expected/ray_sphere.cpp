#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/sphere_tools.h"

namespace halfspace::test {
namespace {

LineObject lineOf(const RayObject &L) { return {L.origin, L.direction}; }

Recomputed recompute(Objects objects) {
  const auto S = objectAs<SphereObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 w = L.origin - S.center;
  Recomputed expected;
  expected.names = {{"c", quantity(S.center)},
                    {"R", quantity(S.radius)},
                    {"Q", quantity(L.origin)},
                    {"\\vec r", quantity(L.direction)},
                    {"\\vec w", quantity(w)}};
  expected.unknowns = {{"t", quantity(somewhere.x)}};
  if (vanishes(w))
    expected.vanished.insert("it.w");
  if (vanishes(L.direction))
    expected.vanished.insert("L.r");
  expected.degenerate = S.radius == 0 || vanishes(L.direction);
  if (S.radius == 0) {
    expected.caseName = "zero-radius";
    expected.vanished.insert("S");
    return expected;
  }
  const Rational outside = product(w, w) - S.radius * S.radius;
  expected.values["origin"] = outside > 0 ? "outside" : outside < 0 ? "inside" : "on";
  if (vanishes(L.direction)) {
    expected.caseName = "zero-direction";
    return expected;
  }
  const Passing passing = addLineAtSphere(expected, S, lineOf(L));
  expected.values["contacts"] = contactsWord(passing);
  // Behind the start: outside, and the nearest point is passed already.
  expected.caseName = passing.partSquared < 0 ? "miss" : outside > 0 && passing.t < 0 ? "behind" : "hit";
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto S = objectAs<SphereObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  if (S.radius == 0 || vanishes(L.direction))
    return {};
  return wrongAnswersAtSphere(S, lineOf(L));
}

} // namespace

namespace expected {

Expected ray_sphere() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
