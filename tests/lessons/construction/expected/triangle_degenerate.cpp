#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// By the three sides: which of them have no length.
std::string sameCorners(const TriangleObject &T) {
  const bool first = vanishes(ExactVec3(T.p1 - T.p0));
  const bool second = vanishes(ExactVec3(T.p2 - T.p0));
  const bool third = vanishes(ExactVec3(T.p2 - T.p1));
  return first && second ? "all" : first ? "P0-P1" : second ? "P0-P2" : third ? "P1-P2" : "none";
}

/// Of an angle whose arrows are not zero: 1 where one is a positive multiple of the other.
std::string sameDirection(const ExactVec3 &u, const ExactVec3 &v) {
  return vanishes(perpendicular(u, v)) && product(u, v) > 0 ? "yes" : "no";
}

Recomputed recompute(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  const bool isAngle = !vanishes(u) && !vanishes(v);
  Recomputed expected;
  expected.degenerate = vanishes(n);
  const std::string same = sameCorners(T);
  expected.caseName = !vanishes(n) ? "proper" : same == "none" ? "collinear" : "coincident";
  expected.values = {{"uu", number(product(u, u))},
                     {"uv", number(product(u, v))},
                     {"vv", number(product(v, v))},
                     {"normal", numbers(n)},
                     {"denominator", number(Rational(-product(n, n)))},
                     {"same_corners", same},
                     {"test_u", same == "P0-P1" || same == "all" ? "yes" : "no"},
                     {"test_v", same == "P0-P2" || same == "all" ? "yes" : "no"},
                     {"test_cosine", isAngle ? sameDirection(u, v) : "undefined"},
                     {"test_squares", vanishes(n) ? "yes" : "no"}};
  expected.names = {{"P_0", quantity(T.p0)},
                    {"P_1", quantity(T.p1)},
                    {"P_2", quantity(T.p2)},
                    {"\\vec u", quantity(u)},
                    {"\\vec v", quantity(v)},
                    {"\\vec n", quantity(n)},
                    {"G", quantity(Rational(-product(n, n)))}};
  if (vanishes(u))
    expected.vanished.insert("it.u");
  if (vanishes(v))
    expected.vanished.insert("it.v");
  if (vanishes(n))
    expected.vanished.insert("it.n");
  if (isAngle) {
    const Rational squares = product(u, u) * product(v, v);
    expected.values["cos_angle"] = SignedSquares{signedSquare(product(u, v), squares)};
    expected.names["\\cos\\theta"] = quantityOverRoot(product(u, v), squares);
  }
  return expected;
}

/// What a difference of (u·v)² and (u·u)(v·v) comes to; `sign` is −1 where the second comes first.
void addDifference(std::vector<WrongAnswer> &all, const char *id, const Rational &uv, const Rational &uu,
                   const Rational &vv, const Rational &sign) {
  Line line(id, Rational(sign * (uv * uv - uu * vv)), all);
  line.add("the sign lost", Rational(sign * (uu * vv - uv * uv)));
  line.add("u·v not squared", Rational(sign * (uv - uu * vv)));
  line.add("u·v doubled instead of squared", Rational(sign * (2 * uv - uu * vv)));
  line.add("the second part dropped", Rational(sign * uv * uv));
  line.add("the first part dropped", Rational(-sign * uu * vv));
  line.add("parts added", Rational(uv * uv + uu * vv));
  line.add("u·u and v·v added", Rational(sign * (uv * uv - (uu + vv))));
  line.add("u·u only", Rational(sign * (uv * uv - uu)));
  line.add("v·v only", Rational(sign * (uv * uv - vv)));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  std::vector<WrongAnswer> all;
  if (vanishes(n))
    return all;
  addVector(all, "u", "reversed", ExactVec3(-u), u);
  addVector(all, "u", "added", ExactVec3(T.p1 + T.p0), u);
  addVector(all, "v", "reversed", ExactVec3(-v), v);
  addVector(all, "v", "added", ExactVec3(T.p2 + T.p0), v);
  addProduct(all, "uu", u, u);
  addProduct(all, "uv", u, v);
  addProduct(all, "vv", v, v);
  addVector(all, "normal", "the other way round", ExactVec3(-n), n);
  addVector(all, "normal", "the second sign lost", {n.x, Rational(-n.y), n.z}, n);
  addCosine(all, u, v);
  addDifference(all, "squares", times(u, v), times(u, u), times(v, v), 1);
  addDifference(all, "lagrange", times(u, v), times(u, u), times(v, v), -1);
  return all;
}

} // namespace

namespace expected {

Expected triangle_degenerate() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
