#include "lessons/object/kinds/line.h"
#include "tests/lessons/construction/expected/acute_angle_tools.h"

namespace halfspace::test {
namespace {

std::string caseOf(const ExactVec3 &v, const ExactVec3 &w) {
  // (v·w)² = (v·v)(w·w) exactly for multiples of each other.
  const Rational square = product(v, w) * product(v, w);
  if (square == product(v, v) * product(w, w))
    return "parallel";
  return square == 0 ? "perpendicular" : "oblique";
}

Recomputed recompute(Objects objects) {
  const auto g = objectAs<LineObject>(*objects[0]).value();
  const auto h = objectAs<LineObject>(*objects[1]).value();
  Recomputed expected;
  expected.names = {{"\\vec v_g", quantity(g.direction)},
                    {"\\vec v_h", quantity(h.direction)},
                    {"A_g", quantity(g.point)},
                    {"A_h", quantity(h.point)}};
  if (vanishes(g.direction))
    expected.vanished.insert("g.v");
  if (vanishes(h.direction))
    expected.vanished.insert("h.v");
  expected.degenerate = !expected.vanished.empty();
  expected.caseName = expected.degenerate ? "zero-direction" : caseOf(g.direction, h.direction);
  if (!expected.degenerate)
    addAcute(expected, "cosine", "\\cos\\varphi", g.direction, h.direction);
  if (expected.caseName == "parallel")
    expected.vanished.insert("it.phi");
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  return acuteWrongAnswers(objectAs<LineObject>(*objects[0])->direction,
                           objectAs<LineObject>(*objects[1])->direction, "length-g", "length-h");
}

} // namespace

namespace expected {

Expected line_angle() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.3};
}

} // namespace expected
} // namespace halfspace::test
