// What recomputations and wrong workings of an angle of at most 90° share.
#pragma once

#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {

/// Adds |a·b|/(|a||b|) of vectors ≠ 0 as the value `name`, which is written `latex`, and their product.
inline void addAcute(Recomputed &expected, const char *name, const char *latex, const ExactVec3 &a,
                     const ExactVec3 &b) {
  const Rational size = abs(product(a, b));
  const Rational squares = product(a, a) * product(b, b);
  expected.values["dot"] = number(product(a, b));
  expected.values[name] = SignedSquares{Rational(size * size / squares)};
  expected.names[latex] = quantityOverRoot(size, squares);
}

/// To the lines of the product, of both lengths, and of |a·b|/(|a||b|).
inline std::vector<WrongAnswer> acuteWrongAnswers(const ExactVec3 &a, const ExactVec3 &b,
                                                  const char *lengthOfA, const char *lengthOfB) {
  std::vector<WrongAnswer> all;
  const Rational size = abs(times(a, b));
  const Rational squares = times(a, a) * times(b, b);
  if (squares == 0)
    return all;
  addProduct(all, "dot", a, b);
  addLength(all, lengthOfA, a);
  addLength(all, lengthOfB, b);
  Line line("angle", Surd::root(squares, Rational(size / squares)), all);
  line.add("not divided", size);
  line.addOverRoot("with a sign", times(a, b), squares);
  line.addOverRoot("divided by the first length only", size, times(a, a));
  line.addOverRoot("divided by the second length only", size, times(b, b));
  line.addRatio("divided by the squares of both lengths", size, squares);
  line.add("only the lengths", Surd::root(squares));
  return all;
}

} // namespace halfspace::test
