#include "lessons/object/kinds/line.h"
#include "tests/lessons/construction/expected/acute_angle_tools.h"

namespace halfspace::test {
namespace {

std::string caseOf(const ExactVec3 &v, const ExactVec3 &n) {
  if (vanishes(n))
    return "zero-normal";
  if (vanishes(v))
    return "zero-direction";
  if (product(v, n) == 0)
    return "parallel";
  // What is left of v in the plane.
  return vanishes(footOf(v, {{0, 0, 0}, n})) ? "perpendicular" : "oblique";
}

Recomputed recompute(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const auto E = objectAs<PlaneObject>(*objects[1]).value();
  Recomputed expected;
  expected.names = {{"\\vec v", quantity(g.direction)},
                    {"\\vec n", quantity(E.normal)},
                    {"A", quantity(g.point)},
                    {"P_0", quantity(E.point)}};
  if (vanishes(g.direction))
    expected.vanished.insert("g.v");
  if (vanishes(E.normal))
    expected.vanished.insert("E.n");
  expected.degenerate = !expected.vanished.empty();
  expected.caseName = caseOf(g.direction, E.normal);
  if (!expected.degenerate)
    addAcute(expected, "sine", "\\sin\\alpha", E.normal, g.direction);
  if (expected.caseName == "parallel")
    expected.vanished.insert("it.alpha");
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  return acuteWrongAnswers(objectAs<PlaneObject>(*objects[1])->normal,
                           objectAs<LineObject>(*objects[0])->direction, "length-n", "length-v");
}

} // namespace

namespace expected {

Expected line_plane_angle() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.3};
}

} // namespace expected
} // namespace halfspace::test
