#include "lessons/object/kinds/vector.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// `a` without its part across `b`: by the triple product b × (a × b) that is the part across, times b·b.
ExactVec3 across(const ExactVec3 &a, const ExactVec3 &b) {
  return perpendicular(b, perpendicular(a, b)) * Rational(1 / product(b, b));
}

void addProjection(Recomputed &expected, const std::string &group, const ExactVec3 &vector,
                   const ExactVec3 &onto) {
  const ExactVec3 rejection = across(vector, onto);
  expected.values[group + ".scalar"] =
      SignedSquares{signedSquare(product(vector, onto), product(onto, onto))};
  expected.values[group + ".projection"] = numbers(ExactVec3(vector - rejection));
  expected.values[group + ".rejection"] = numbers(rejection);
}

std::string caseOf(const ExactVec3 &v, const ExactVec3 &w) {
  const Rational dot = product(v, w);
  if (vanishes(perpendicular(v, w)))
    return dot > 0 ? "same-direction" : "opposite";
  return dot > 0 ? "acute" : dot < 0 ? "obtuse" : "right";
}

Recomputed recompute(Objects objects) {
  const ExactVec3 v = objectAs<VectorObject>(*objects[0])->vector;
  const ExactVec3 w = objectAs<VectorObject>(*objects[1])->vector;
  const Rational dot = product(v, w);
  const Rational vv = product(v, v);
  const Rational ww = product(w, w);
  Recomputed expected;
  expected.degenerate = vv == 0 || ww == 0;
  expected.caseName = expected.degenerate ? "zero-vector" : caseOf(v, w);
  expected.values = {{"dot", number(dot)},
                     {"sign", dot > 0   ? "positive"
                              : dot < 0 ? "negative"
                                        : "zero"},
                     {"length_v", SignedSquares{vv}},
                     {"length_w", SignedSquares{ww}}};
  expected.names = {{"\\vec v", quantity(v)}, {"\\vec w", quantity(w)}};
  if (vv == 0)
    expected.vanished.insert({"v.v", "it.e", "it.vprime", "it.h"});
  if (ww == 0)
    expected.vanished.insert({"w.v", "it.wprime"});
  if (dot == 0)
    expected.vanished.insert({"it.vprime", "it.wprime"});
  if (expected.degenerate)
    expected.vanished.insert({"it.theta", "it.h"});
  if (vv != 0) {
    expected.values["unit_v"] = normalizedNumbers(v, vv);
    addProjection(expected, "onto_v", w, v);
    const ExactVec3 rejection = across(w, v);
    expected.names["\\vec v'"] = quantity(ExactVec3(w - rejection));
    expected.names["\\vec h"] = quantity(rejection);
    if (vanishes(rejection))
      expected.vanished.insert("it.h");
    expected.names["\\vec e"] = quantityOverRoot(v, vv);
  }
  if (ww != 0) {
    addProjection(expected, "onto_w", v, w);
    expected.names["\\vec w'"] = quantity(ExactVec3(v - across(v, w)));
  }
  if (!expected.degenerate) {
    expected.values["cos_angle"] = SignedSquares{signedSquare(dot, vv * ww)};
    expected.names["\\cos\\theta"] = quantityOverRoot(dot, vv * ww);
  }
  return expected;
}

void addReach(std::vector<WrongAnswer> &all, const Rational &dot, const Rational &vv, const Rational &ww) {
  Line reach("reach", Surd::root(vv, Rational(dot / vv)), all);
  reach.add("not divided", dot);
  reach.addRatio("divided by v·v", dot, vv);
  reach.addRatio("divided by w·w", dot, ww);
  reach.addOverRoot("divided by |w|", dot, ww);
  reach.addOverRoot("divided by both lengths", dot, Rational(vv * ww));
  reach.addOverRoot("the sign lost", Rational(-dot), vv);
  reach.add("multiplied instead of divided", Surd::root(vv, dot));
  reach.add("the length of w", Surd::root(ww));
}

/// Of a projected vector onto another, whose product is `dot`.
void addProjections(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &onto,
                    const ExactVec3 &vector) {
  const Rational dot = times(onto, vector);
  const Rational square = times(onto, onto);
  const ExactVec3 right = onto * Rational(dot / square);
  addVector(all, id, "as if it had the length 1", ExactVec3(onto * dot), right);
  addVector(all, id, "the sign lost", ExactVec3(-right), right);
  addVector(all, id, "the other vector scaled", ExactVec3(vector * Rational(dot / square)), right);
  addVector(all, id, "what is left", ExactVec3(vector - right), right);
  if (times(vector, vector) != 0)
    addVector(all, id, "the other projection", ExactVec3(vector * Rational(dot / times(vector, vector))),
              right);
  if (dot != 0)
    addVector(all, id, "the fraction upside down", ExactVec3(onto * Rational(square / dot)), right);
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const ExactVec3 v = objectAs<VectorObject>(*objects[0])->vector;
  const ExactVec3 w = objectAs<VectorObject>(*objects[1])->vector;
  std::vector<WrongAnswer> all;
  if (times(v, v) == 0 || times(w, w) == 0)
    return all;
  addProduct(all, "dot", v, w);
  addLength(all, "length-v", v);
  addLength(all, "length-w", w);
  addCosine(all, v, w);
  addReach(all, times(v, w), times(v, v), times(w, w));
  addProjections(all, "projection", v, w);
  addProjections(all, "other-projection", w, v);
  const ExactVec3 part = v * Rational(times(v, w) / times(v, v));
  addVector(all, "rest", "the difference reversed", ExactVec3(part - w), ExactVec3(w - part));
  addVector(all, "rest", "added", ExactVec3(part + w), ExactVec3(w - part));
  return all;
}

} // namespace

namespace expected {

Expected dot_product_projection() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
