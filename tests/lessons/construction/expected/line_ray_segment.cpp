#include "lessons/object/kinds/line.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

struct Walk {
  explicit Walk(Objects objects)
      : g(objectAs<LineObject>(*objects[0]).value()), P(objectAs<PointObject>(*objects[1])->at),
        Q(objectAs<PointObject>(*objects[2])->at) {}

  bool isLine() const { return !vanishes(g.direction); }
  bool isOn(const ExactVec3 &point) const {
    return isLine() && vanishes(perpendicular(ExactVec3(point - g.point), g.direction));
  }
  /// Of a point of the line, by the part of the way to it along the direction.
  Rational stepsTo(const ExactVec3 &point) const {
    return product(ExactVec3(point - g.point), g.direction) / product(g.direction, g.direction);
  }
  std::string partOf(const ExactVec3 &point) const {
    if (!isLine())
      return "zero-direction";
    if (!isOn(point))
      return "off";
    const Rational t = stepsTo(point);
    return t < 0 ? "before" : t * (1 - t) >= 0 ? "segment" : "beyond";
  }
  ExactVec3 tip() const { return g.point + g.direction; }

  LineObject g;
  ExactVec3 P;
  ExactVec3 Q;
};

constexpr std::array axes{"x", "y", "z"};

void nameCoordinates(Recomputed &expected, const Walk &walk) {
  for (int axis = 0; axis < 3; ++axis) {
    const std::string index = axes.at(static_cast<std::size_t>(axis));
    expected.names["A_" + index] = quantity(walk.g.point[axis]);
    expected.names["v_" + index] = quantity(walk.g.direction[axis]);
    expected.names["Q_" + index] = quantity(walk.Q[axis]);
    if (walk.g.direction[axis] == 0)
      continue;
    // so much farther than a point one step before A
    const Rational before = walk.g.point[axis] - walk.g.direction[axis];
    const Rational t = (walk.Q[axis] - before) / walk.g.direction[axis] - 1;
    expected.names["t_" + index] = quantity(t);
    expected.values["t_" + index] = number(t);
  }
}

Recomputed recompute(Objects objects) {
  const Walk walk(objects);
  Recomputed expected;
  expected.caseName = walk.partOf(walk.Q);
  expected.degenerate = !walk.isLine();
  expected.names = {{"A", quantity(walk.g.point)},
                    {"\\vec v", quantity(walk.g.direction)},
                    {"P", quantity(walk.P)},
                    {"Q", quantity(walk.Q)}};
  expected.values = {{"direction", numbers(walk.g.direction)}};
  if (!walk.isLine()) {
    expected.vanished.insert("g.v");
    return expected;
  }
  nameCoordinates(expected, walk);
  expected.names["B"] = quantity(walk.tip());
  expected.values["tip"] = numbers(walk.tip());
  expected.values["part"] = walk.partOf(walk.P);
  expected.values["on"] = walk.isOn(walk.Q) ? "yes" : "no";
  if (walk.isOn(walk.P)) {
    expected.values["t"] = number(walk.stepsTo(walk.P));
    expected.names["t"] = quantity(walk.stepsTo(walk.P));
  }
  if (walk.isOn(walk.Q)) {
    expected.values["t_Q"] = number(walk.stepsTo(walk.Q));
    expected.names["t_Q"] = quantity(walk.stepsTo(walk.Q));
  }
  return expected;
}

void addSteps(std::vector<WrongAnswer> &all, const Walk &walk, int axis) {
  const Rational &start = walk.g.point[axis];
  const Rational &end = walk.Q[axis];
  const Rational &step = walk.g.direction[axis];
  if (step == 0)
    return;
  Line line(axes.at(static_cast<std::size_t>(axis)), Rational((end - start) / step), all);
  addFraction(line, Rational(end - start), step);
  line.addRatio("added", Rational(end + start), step);
  line.addRatio("the start forgotten", end, step);
  line.addRatio("the end forgotten", start, step);
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Walk walk(objects);
  std::vector<WrongAnswer> all;
  if (!walk.isLine())
    return all;
  addVector(all, "v", "the other way round", ExactVec3(-walk.g.direction), walk.g.direction);
  addVector(all, "v", "added", ExactVec3(walk.tip() + walk.g.point), walk.g.direction);
  addVector(all, "tip", "subtracted", ExactVec3(walk.g.point - walk.g.direction), walk.tip());
  for (int axis = 0; axis < 3; ++axis)
    addSteps(all, walk, axis);
  if (!walk.isOn(walk.P))
    return all;
  const Rational t = walk.stepsTo(walk.P);
  addPointOnRay(all, "point", walk.g.point, t, walk.g.direction);
  addVector(all, "mixed", "weights exchanged", ExactVec3(walk.g.point * t + walk.tip() * Rational(1 - t)),
            walk.P);
  addVector(all, "mixed", "the first weight forgotten", ExactVec3(walk.g.point + walk.tip() * t), walk.P);
  return all;
}

} // namespace

namespace expected {

Expected line_ray_segment() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
