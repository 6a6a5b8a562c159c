#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// Where a point of the triangle's plane lies, by the signs of the areas that it makes with each side.
struct Location {
  std::string word;
  std::optional<int> feature;
};

Location locationOf(const ExactVec3 &point, const std::array<ExactVec3, 3> &corners,
                    const ExactVec3 &normal) {
  std::vector<int> zero;
  std::vector<int> positive;
  for (int i = 0; i < 3; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const ExactVec3 &from = corners[(index + 1) % 3];
    const Rational area =
        determinant(normal, ExactVec3(corners[(index + 2) % 3] - from), ExactVec3(point - from));
    if (area < 0)
      return {"outside", {}};
    (area == 0 ? zero : positive).push_back(i);
  }
  return zero.empty()       ? Location{"interior", {}}
         : zero.size() == 1 ? Location{"edge", zero.front()}
                            : Location{"vertex", positive.front()};
}

/// The triangle's own values and names; true where it is a triangle.
bool recomputeTriangle(const TriangleObject &T, Recomputed &expected) {
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  const ExactVec3 uPerp = perpendicular(n, u);
  const ExactVec3 vPerp = perpendicular(n, v);
  expected.values = {
      {"perp.u_perp", numbers(uPerp)},    {"perp.v_perp", numbers(vPerp)},
      {"perp.uu", number(product(u, u))}, {"perp.uv", number(product(u, v))},
      {"perp.vv", number(product(v, v))}, {"perp.denominator", number(Rational(-product(n, n)))}};
  expected.names = {{"P_0", quantity(T.p0)},
                    {"P_1", quantity(T.p1)},
                    {"P_2", quantity(T.p2)},
                    {"\\vec u", quantity(u)},
                    {"\\vec v", quantity(v)},
                    {"\\vec n", quantity(n)},
                    {"\\vec u^{\\perp}", quantity(uPerp)},
                    {"\\vec v^{\\perp}", quantity(vPerp)},
                    {"G", quantity(Rational(-product(n, n)))}};
  if (!vanishes(n))
    return true;
  expected.degenerate = true;
  expected.vanished = {"it.n", "it.uperp", "it.vperp"};
  expected.caseName = T.p0 == T.p1 || T.p1 == T.p2 || T.p2 == T.p0 ? "coincident" : "collinear";
  return false;
}

Recomputed recompute(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  Recomputed expected;
  const bool isTriangle = recomputeTriangle(T, expected);
  expected.names["Q"] = quantity(L.origin);
  expected.names["\\vec r"] = quantity(L.direction);
  if (vanishes(L.direction)) {
    expected.vanished.insert("L.r");
    expected.degenerate = true;
  }
  if (!isTriangle)
    return expected;
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  // Cramer's rule for s·u + t·v − λ·r = Q − P0.
  const ExactVec3 back = -L.direction;
  const ExactVec3 right = L.origin - T.p0;
  const Rational whole = determinant(u, v, back);
  if (whole == 0) {
    expected.caseName = vanishes(L.direction)           ? "zero-direction"
                        : determinant(u, v, right) == 0 ? "in-plane"
                                                        : "parallel";
    return expected;
  }
  const Rational s = determinant(right, v, back) / whole;
  const Rational t = determinant(u, right, back) / whole;
  const Rational lambda = determinant(u, v, right) / whole;
  const ExactVec3 point = T.p0 + u * s + v * t;
  const ExactVec3 w = point - T.p0;
  const Location location = locationOf(point, {T.p0, T.p1, T.p2}, perpendicular(u, v));
  expected.caseName = location.word == "outside" ? "miss" : lambda < 0 ? "behind" : "hit";
  expected.values["location"] = location.word;
  if (location.feature)
    expected.values["feature"] = *location.feature;
  expected.values["t"] = number(lambda);
  expected.values["point"] = numbers(point);
  expected.values["s"] = number(s);
  expected.values["t_triangle"] = number(t);
  expected.values["barycentric"] = numbers({Rational(1 - s - t), s, t});
  expected.values["perp.wu"] = number(product(w, u));
  expected.values["perp.wv"] = number(product(w, v));
  const ExactVec3 uPerp = perpendicular(perpendicular(u, v), u);
  const Rational perpSquare = product(uPerp, uPerp);
  // t·v and w have the same foot on u⊥.
  const ExactVec3 footOfW = T.p0 + uPerp * (product(w, uPerp) / perpSquare);
  const ExactVec3 footOfV = T.p0 + uPerp * (product(v, uPerp) / perpSquare);
  expected.names.insert({{"I", quantity(point)},
                         {"\\vec w", quantity(w)},
                         {"\\lambda", quantity(lambda)},
                         {"s", quantity(s)},
                         {"t", quantity(t)},
                         {"a", quantity(product(w, uPerp))},
                         {"b", quantity(product(v, uPerp))},
                         {"A", quantity(footOfW)},
                         {"B", quantity(footOfV)},
                         {"C", quantity(ExactVec3(T.p0 + v * t))}});
  return expected;
}

/// The five dot products, as the share of u or of v takes them.
struct Products {
  Rational uv;
  Rational own;   ///< of the other side with itself: v·v for s, u·u for t
  Rational other; ///< of w with the other side: w·v for s, w·u for t
  Rational same;  ///< of w with the side itself: w·u for s, w·v for t
};

/// s = ((u·v)(w·v) − (v·v)(w·u))/D, and t likewise.
void addShare(std::vector<WrongAnswer> &all, const char *id, const Products &of, const Rational &D,
              const Rational &otherShare) {
  const Rational first = of.uv * of.other;
  const Rational second = of.own * of.same;
  const Rational top = first - second;
  Line line(id, Rational(top / D), all);
  addFraction(line, top, D);
  line.add("the other share", otherShare);
  line.add("what is left to one", Rational(1 - top / D));
  line.addRatio("in the numerator: the second part dropped", first, D);
  line.addRatio("in the numerator: the first part dropped", Rational(-second), D);
  line.addRatio("in the numerator: parts added", Rational(first + second), D);
  line.addRatio("in the numerator: w·u and w·v swapped", Rational(of.uv * of.same - of.own * of.other), D);
  const Rational uu_vv = of.uv * of.uv - D;
  line.addRatio("in the denominator: u·v not squared", top, Rational(of.uv - uu_vv));
  line.addRatio("in the denominator: the second part dropped", top, Rational(of.uv * of.uv));
  line.addRatio("in the denominator: the first part dropped", top, Rational(-uu_vv));
  line.addRatio("in the denominator: parts added", top, Rational(of.uv * of.uv + uu_vv));
}

void addDenominator(std::vector<WrongAnswer> &all, const ExactVec3 &u, const ExactVec3 &v) {
  const Rational uv = times(u, v);
  const Rational uu = times(u, u);
  const Rational vv = times(v, v);
  const Rational D = uv * uv - uu * vv;
  Line line("denominator", D, all);
  line.add("the sign lost", Rational(-D));
  line.add("u·v not squared", Rational(uv - uu * vv));
  line.add("u·v doubled instead of squared", Rational(2 * uv - uu * vv));
  line.add("the second part dropped", Rational(uv * uv));
  line.add("the first part dropped", Rational(-uu * vv));
  line.add("the first part and a sign dropped", Rational(uu * vv));
  line.add("parts added", Rational(uv * uv + uu * vv));
  line.add("u·u and v·v added", Rational(uv * uv - (uu + vv)));
  line.add("u·u only", Rational(uv * uv - uu));
  line.add("v·v only", Rational(uv * uv - vv));
  line.add("u·u for v·v", Rational(uv * uv - uu * uu));
  line.add("v·v for u·u", Rational(uv * uv - vv * vv));
  line.add("the square and its parts negative", Rational(-uv * uv - uu * vv));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  std::vector<WrongAnswer> all;
  addProduct(all, "uu", u, u);
  addProduct(all, "uv", u, v);
  addProduct(all, "vv", v, v);
  addDenominator(all, u, v);
  if (times(n, L.direction) == 0)
    return all;
  addParameter(all, "plane-t", n, T.p0, L);
  const Rational lambda = times(n, ExactVec3(T.p0 - L.origin)) / times(n, L.direction);
  const ExactVec3 w = L.origin + L.direction * lambda - T.p0;
  addProduct(all, "wu", w, u);
  addProduct(all, "wv", w, v);
  const Rational D = -times(n, n);
  const Rational s = times(perpendicular(w, v), n) / -D;
  const Rational t = times(perpendicular(u, w), n) / -D;
  addShare(all, "s", {times(u, v), times(v, v), times(w, v), times(w, u)}, D, t);
  addShare(all, "t", {times(u, v), times(u, u), times(w, u), times(w, v)}, D, s);
  const ExactVec3 uPerp = perpendicular(n, u);
  addProduct(all, "a", w, uPerp);
  addProduct(all, "b", v, uPerp);
  return all;
}

} // namespace

namespace expected {

Expected ray_triangle_perp() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.46};
}

} // namespace expected
} // namespace halfspace::test
