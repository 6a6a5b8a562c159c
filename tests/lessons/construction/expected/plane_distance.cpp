#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto F = objectAs<PlaneObject>(*objects[1]).value();
  const ExactVec3 w = F.point - E.point;
  Recomputed expected;
  expected.names = {
      {"\\vec n_E", quantity(E.normal)}, {"\\vec n_F", quantity(F.normal)},
      {"P_{0,E}", quantity(E.point)},    {"P_{0,F}", quantity(F.point)},
      {"\\vec w", quantity(w)},          {"\\vec c", quantity(perpendicular(E.normal, F.normal))}};
  if (vanishes(E.normal))
    expected.vanished.insert("E.n");
  if (vanishes(F.normal))
    expected.vanished.insert("F.n");
  expected.degenerate = !expected.vanished.empty();
  if (expected.degenerate) {
    expected.caseName = "zero-normal";
    return expected;
  }
  if (vanishes(w))
    expected.vanished.insert("it.w");
  // From a point of F to its foot in E, where the planes do not meet.
  const ExactVec3 way = F.point - footOf(F.point, E);
  const bool meet = !vanishes(perpendicular(E.normal, F.normal));
  expected.caseName = meet ? "meet" : vanishes(way) ? "coincident" : "parallel";
  const Rational square = meet ? Rational(0) : product(way, way);
  expected.values["distance"] = SignedSquares{square};
  expected.names["\\operatorname{dist}"] =
      square == 0 ? quantity(Rational(0)) : quantityOverRoot(square, square);
  if (square == 0)
    expected.vanished.insert("it.dist");
  return expected;
}

void addDistance(std::vector<WrongAnswer> &all, const ExactVec3 &n, const ExactVec3 &w) {
  const Rational reach = abs(times(n, w));
  const Rational square = times(n, n);
  Line line("distance", Surd::root(square, Rational(reach / square)), all);
  line.add("not divided", reach);
  line.addRatio("divided by n·n", reach, square);
  line.addOverRoot("with a sign", times(n, w), square);
  line.add("the whole way", Surd::root(times(w, w)));
  line.add("multiplied instead of divided", Surd::root(square, reach));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto F = objectAs<PlaneObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  if (vanishes(E.normal) || vanishes(F.normal))
    return all;
  const ExactVec3 common = perpendicular(E.normal, F.normal);
  addVector(all, "cross", "the other way round", ExactVec3(-common), common);
  for (int i = 0; i < 3; ++i) {
    ExactVec3 wrong = common;
    wrong[i] = -common[i];
    addVector(all, "cross", "one coordinate's sign lost", wrong, common);
    wrong[i] = E.normal[(i + 1) % 3] * F.normal[(i + 2) % 3] + E.normal[(i + 2) % 3] * F.normal[(i + 1) % 3];
    addVector(all, "cross", "one coordinate's products added", wrong, common);
  }
  if (!vanishes(common))
    return all;
  const ExactVec3 w = F.point - E.point;
  addVector(all, "w", "reversed", ExactVec3(-w), w);
  addVector(all, "w", "added", ExactVec3(E.point + F.point), w);
  addProduct(all, "reach", E.normal, w);
  addDistance(all, E.normal, w);
  return all;
}

} // namespace

namespace expected {

Expected plane_distance() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.3};
}

} // namespace expected
} // namespace halfspace::test
