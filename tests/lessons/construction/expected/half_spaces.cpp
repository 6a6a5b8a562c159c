#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

const std::array<std::string, 4> roles{"A", "B", "C", "D"};

ExactVec3 pointAt(Objects objects, std::size_t index) {
  return objectAs<PointObject>(*objects[index + 1])->at;
}

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const bool hasPlane = !vanishes(E.normal);
  Recomputed expected;
  expected.names = {{"\\vec n", quantity(E.normal)}, {"P_0", quantity(E.point)}};
  std::map<std::string, int> count{{"positive", 0}, {"negative", 0}, {"on", 0}};
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const std::string &role = roles.at(i);
    const ExactVec3 at = pointAt(objects, i);
    const Rational f = product(E.normal, at) - product(E.normal, E.point);
    const std::string side = f > 0 ? "positive" : f < 0 ? "negative" : "on";
    expected.names[role] = quantity(at);
    expected.names["f(" + role + ")"] = quantity(f);
    expected.values["f_" + role] = number(f);
    ++count[side];
    if (hasPlane)
      expected.values["side_" + role] = side;
    else
      expected.vanished.insert("it.side-" + role);
  }
  expected.degenerate = !hasPlane;
  expected.caseName = "zero-normal";
  if (!hasPlane) {
    expected.vanished.insert("E.n");
    return expected;
  }
  expected.caseName = count["positive"] * count["negative"] > 0 ? "split" : "one-side";
  for (const auto &[side, points] : count)
    expected.values[side] = number(points);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  std::vector<WrongAnswer> all;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    const ExactVec3 at = pointAt(objects, i);
    Line line("f-" + roles.at(i), times(E.normal, ExactVec3(at - E.point)), all);
    addSlips(line, differenceSlips(E.normal, at, E.point));
  }
  if (!vanishes(E.normal)) {
    const ExactVec3 flipped = -E.normal;
    const ExactVec3 at = pointAt(objects, 0);
    Line line("flipped", times(flipped, ExactVec3(at - E.point)), all);
    addSlips(line, differenceSlips(flipped, at, E.point));
  }
  return all;
}

} // namespace

namespace expected {

Expected half_spaces() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
