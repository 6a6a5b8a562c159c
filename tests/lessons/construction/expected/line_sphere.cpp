#include "tests/lessons/construction/expected/sphere_tools.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const auto S = objectAs<SphereObject>(*objects[1]).value();
  const ExactVec3 w = g.point - S.center;
  Recomputed expected;
  expected.names = {{"c", quantity(S.center)},
                    {"R", quantity(S.radius)},
                    {"A", quantity(g.point)},
                    {"\\vec v", quantity(g.direction)},
                    {"\\vec w", quantity(w)}};
  expected.unknowns = {{"t", quantity(somewhere.x)}};
  if (vanishes(w))
    expected.vanished.insert("it.w");
  if (vanishes(g.direction))
    expected.vanished.insert("g.v");
  if (S.radius == 0)
    expected.vanished.insert("S");
  expected.degenerate = S.radius == 0 || vanishes(g.direction);
  if (expected.degenerate)
    expected.caseName = S.radius == 0 ? "zero-radius" : "zero-direction";
  else
    expected.caseName = contactsWord(addLineAtSphere(expected, S, g));
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const auto S = objectAs<SphereObject>(*objects[1]).value();
  if (S.radius == 0 || vanishes(g.direction))
    return {};
  return wrongAnswersAtSphere(S, g);
}

} // namespace

namespace expected {

Expected line_sphere() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
