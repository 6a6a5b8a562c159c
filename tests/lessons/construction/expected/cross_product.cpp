#include "lessons/object/kinds/vector.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// `v` without its part along `u`, times u·u: (u·u)v − (u·v)u.
ExactVec3 acrossTimesSquare(const ExactVec3 &u, const ExactVec3 &v) {
  return v * product(u, u) - u * product(u, v);
}

std::string caseOf(const ExactVec3 &u, const ExactVec3 &v) {
  if (vanishes(u) || vanishes(v))
    return "zero-vector";
  if (!vanishes(perpendicular(u, v)))
    return "proper";
  return product(u, v) > 0 ? "same-direction" : "opposite";
}

std::string wayOf(const ExactVec3 &n) {
  return vanishes(n) ? "nowhere" : n.z > 0 ? "up" : n.z < 0 ? "down" : "level";
}

Recomputed recompute(Objects objects) {
  const ExactVec3 u = objectAs<VectorObject>(*objects[0])->vector;
  const ExactVec3 v = objectAs<VectorObject>(*objects[1])->vector;
  const ExactVec3 n = perpendicular(u, v);
  const ExactVec3 uPerp = acrossTimesSquare(u, v);
  const Rational uu = product(u, u);
  const Rational vv = product(v, v);
  const Rational nn = product(n, n);
  Recomputed expected;
  expected.caseName = caseOf(u, v);
  expected.degenerate = expected.caseName != "proper";
  expected.values = {{"cross", numbers(n)},
                     {"points", wayOf(n)},
                     {"length", SignedSquares{nn}},
                     {"parallelogram", SignedSquares{nn}},
                     {"triangle", SignedSquares{Rational(nn / 4)}},
                     {"uu", number(uu)},
                     {"uv", number(product(u, v))},
                     {"vv", number(vv)},
                     {"squares", number(nn)},
                     {"length_u", SignedSquares{uu}},
                     {"length_v", SignedSquares{vv}},
                     {"u_perp", numbers(uPerp)}};
  expected.names = {{"\\vec u", quantity(u)},
                    {"\\vec v", quantity(v)},
                    {"\\vec n", quantity(n)},
                    {"\\vec u^{\\perp}", quantity(uPerp)}};
  if (uu == 0)
    expected.vanished.insert("u.v");
  if (vv == 0)
    expected.vanished.insert("v.v");
  if (uu == 0 || vv == 0) {
    expected.vanished.insert("it.theta");
  } else {
    expected.values["sin_angle"] = SignedSquares{Rational(nn / (uu * vv))};
    expected.names["\\sin\\theta"] = quantity(Surd::root(Rational(nn / (uu * vv))));
  }
  if (expected.degenerate) {
    expected.vanished.insert(
        {"it.n", "it.right-u", "it.right-v", "it.area", "it.triangle", "it.height", "it.uperp", "it.turned"});
  } else {
    expected.values["height"] = SignedSquares{Rational(nn / uu)};
    expected.values["turned"] = normalizedNumbers(uPerp, nn);
  }
  return expected;
}

void addAreas(std::vector<WrongAnswer> &all, const ExactVec3 &u, const ExactVec3 &v, const ExactVec3 &n) {
  const Rational nn = times(n, n);
  addLength(all, "length", n);
  Line height("height", Surd::root(Rational(nn / times(u, u))), all);
  height.add("not divided", Surd::root(nn));
  height.add("divided by u·u", Surd::root(nn, Rational(1 / times(u, u))));
  height.add("divided by |v|", Surd::root(Rational(nn / times(v, v))));
  height.add("the length of v", Surd::root(times(v, v)));
  Line triangle("triangle", Surd::root(Rational(nn / 4)), all);
  triangle.add("not halved", Surd::root(nn));
  triangle.add("doubled", Surd::root(Rational(nn * 4)));
  triangle.add("no root", Rational(nn / 2));
}

void addSquares(std::vector<WrongAnswer> &all, const ExactVec3 &u, const ExactVec3 &v) {
  const Rational uu = times(u, u);
  const Rational vv = times(v, v);
  const Rational uv = times(u, v);
  Line line("squares", Rational(uu * vv - uv * uv), all);
  line.add("the parts swapped", Rational(uv * uv - uu * vv));
  line.add("the parts added", Rational(uu * vv + uv * uv));
  line.add("u·v not squared", Rational(uu * vv - uv));
  line.add("u·v doubled instead of squared", Rational(uu * vv - 2 * uv));
  line.add("nothing taken away", Rational(uu * vv));
  line.add("u·u and v·v added", Rational(uu + vv - uv * uv));
}

void addSine(std::vector<WrongAnswer> &all, const ExactVec3 &u, const ExactVec3 &v, const Rational &nn) {
  const Rational uu = times(u, u);
  const Rational vv = times(v, v);
  Line line("sine", Surd::root(Rational(nn / (uu * vv))), all);
  line.add("not divided", Surd::root(nn));
  line.add("divided by |u| only", Surd::root(Rational(nn / uu)));
  line.add("divided by |v| only", Surd::root(Rational(nn / vv)));
  line.add("the roots of the lengths forgotten", Surd::root(nn, Rational(1 / (uu * vv))));
  line.add("upside down", Surd::root(Rational(uu * vv / nn)));
  line.addOverRoot("the cosine", times(u, v), Rational(uu * vv));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const ExactVec3 u = objectAs<VectorObject>(*objects[0])->vector;
  const ExactVec3 v = objectAs<VectorObject>(*objects[1])->vector;
  const ExactVec3 n = perpendicular(u, v);
  std::vector<WrongAnswer> all;
  if (vanishes(n))
    return all;
  addCross(all, "cross", u, v);
  addCross(all, "reverse", v, u);
  addCross(all, "uperp", n, u);
  addAreas(all, u, v, n);
  addSquares(all, u, v);
  addSine(all, u, v, times(n, n));
  const ExactVec3 uPerp = acrossTimesSquare(u, v);
  addVector(all, "in-plane", "the parts swapped", ExactVec3(-uPerp), uPerp);
  addVector(all, "in-plane", "the parts added", ExactVec3(v * times(u, u) + u * times(u, v)), uPerp);
  addVector(all, "in-plane", "u and v swapped", acrossTimesSquare(v, u), uPerp);
  return all;
}

} // namespace

namespace expected {

Expected cross_product() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
