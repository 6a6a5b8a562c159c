#include "lessons/object/kinds/polygon.h"
#include "tests/lessons/construction/expected/flat_corners.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

std::string caseOf(const CornerList &corners) {
  if (areOnOneLine(corners))
    return "on-one-line";
  return !areInOnePlane(corners) ? "not-planar" : doesBoundaryMeetItself(corners) ? "self-meeting" : "simple";
}

/// By Gauss's trapezoid formula in each of the planes of the axes: no corner is subtracted from another.
ExactVec3 twiceArea(const CornerList &corners) {
  ExactVec3 sum{0, 0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactVec3 &a = corners[i];
    const ExactVec3 &b = corners[(i + 1) % corners.size()];
    for (int axis = 0; axis < 3; ++axis) {
      const int x = (axis + 1) % 3;
      const int y = (axis + 2) % 3;
      sum[axis] += (a[x] - b[x]) * (a[y] + b[y]);
    }
  }
  return sum;
}

Recomputed recompute(Objects objects) {
  const CornerList corners = objectAs<PolygonObject>(*objects[0])->corners;
  Recomputed expected;
  expected.caseName = caseOf(corners);
  expected.degenerate = expected.caseName != "simple";
  const ExactVec3 n = twiceArea(corners);
  expected.values["normal"] = numbers(n);
  expected.names["\\vec n"] = quantity(n);
  if (vanishes(n))
    expected.vanished.insert("it.n");
  for (std::size_t i = 0; i < corners.size(); ++i)
    expected.names["P_" + std::to_string(i)] = quantity(corners[i]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    expected.names["\\vec n_" + std::to_string(i)] =
        quantity(twiceArea({corners[0], corners[i], corners[i + 1]}));
  if (expected.caseName == "not-planar")
    return expected;
  const Rational square = product(n, n) / 4;
  expected.values["area"] = SignedSquares{square};
  expected.names["A"] = quantity(Surd::root(square));
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const CornerList corners = objectAs<PolygonObject>(*objects[0])->corners;
  std::vector<WrongAnswer> all;
  if (caseOf(corners) != "simple")
    return all;
  const ExactVec3 n = twiceArea(corners);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const std::string id = "triangle" + std::to_string(i);
    addCross(all, id.c_str(), ExactVec3(corners[i] - corners[0]), ExactVec3(corners[i + 1] - corners[0]));
  }
  const Rational square = times(n, n);
  Line area("area", Surd::root(Rational(square / 4)), all);
  area.add("not halved", Surd::root(square));
  area.add("the root forgotten", Rational(square / 2));
  return all;
}

} // namespace

namespace expected {

Expected polygon_area() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
