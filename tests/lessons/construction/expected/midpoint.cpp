#include "tests/lessons/construction/expected/two_points.h"

#include <tuple>

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const PointPair pair(objects);
  Recomputed expected = recomputedPair(pair);
  // As far back from B as it is on from A.
  const ExactVec3 middle = pair.B - pair.way() * Rational(1, 2);
  expected.values["point"] = numbers(middle);
  expected.names["M"] = quantity(middle);
  return expected;
}

void addMean(std::vector<WrongAnswer> &all, const PointPair &pair) {
  const auto &[A, B] = std::tie(pair.A, pair.B);
  const ExactVec3 right = (A + B) / Rational(2);
  const auto add = [&](const char *how, const ExactVec3 &wrong) {
    addVector(all, "mean", how, wrong, right);
  };
  add("not halved", A + B);
  add("half of the way alone", pair.way() / Rational(2));
  add("half of the way back", ExactVec3(-pair.way()) / Rational(2));
  add("only the second halved", A + B / Rational(2));
  add("only the first halved", A / Rational(2) + B);
  add("doubled", (A + B) * Rational(2));
  for (int i = 0; i < 3; ++i) {
    ExactVec3 wrong = right;
    wrong[i] = A[i] + B[i];
    add("one coordinate not halved", wrong);
    wrong[i] = (B[i] - A[i]) / 2;
    add("one coordinate subtracted", wrong);
  }
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const PointPair pair(objects);
  std::vector<WrongAnswer> all;
  addMean(all, pair);
  addWay(all, pair);
  addPointOnRay(all, "half", pair.A, Rational(1, 2), pair.way());
  return all;
}

} // namespace

namespace expected {

Expected midpoint() { return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.3}; }

} // namespace expected
} // namespace halfspace::test
