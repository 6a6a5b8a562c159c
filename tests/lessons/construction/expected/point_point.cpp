#include "tests/lessons/construction/expected/two_points.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const PointPair pair(objects);
  Recomputed expected = recomputedPair(pair);
  // |B − A|² = B·B − 2 A·B + A·A
  const Rational square = product(pair.B, pair.B) - 2 * product(pair.A, pair.B) + product(pair.A, pair.A);
  expected.values = {{"squared", number(square)}, {"distance", SignedSquares{square}}};
  expected.names["\\operatorname{dist}"] =
      square == 0 ? quantity(Rational(0)) : quantityOverRoot(square, square);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const PointPair pair(objects);
  std::vector<WrongAnswer> all;
  addWay(all, pair);
  addProduct(all, "squared", pair.way(), pair.way());
  addLength(all, "distance", pair.way());
  return all;
}

} // namespace

namespace expected {

Expected point_point() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
