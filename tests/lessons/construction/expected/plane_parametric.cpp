#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// The place and the feature by the three shares.
void addLocation(const std::array<Rational, 3> &shares, Recomputed &expected) {
  const auto count = [&](auto holds) { return std::count_if(shares.begin(), shares.end(), holds); };
  const auto indexOf = [&](auto holds) {
    return static_cast<int>(std::find_if(shares.begin(), shares.end(), holds) - shares.begin());
  };
  const auto isZero = [](const Rational &share) { return share == 0; };
  const auto isNegative = [](const Rational &share) { return share < 0; };
  const auto isPositive = [](const Rational &share) { return share > 0; };
  if (count(isNegative) > 0) {
    expected.values["location"] = "outside";
  } else if (count(isZero) == 0) {
    expected.values["location"] = "interior";
  } else {
    expected.values["location"] = count(isZero) == 1 ? "edge" : "vertex";
    expected.values["feature"] = count(isZero) == 1 ? indexOf(isZero) : indexOf(isPositive);
  }
}

/// The triangle's own values and names; true where it is a triangle.
bool recomputeTriangle(const TriangleObject &T, Recomputed &expected) {
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  expected.names = {{"P_0", quantity(T.p0)},  {"P_1", quantity(T.p1)},
                    {"P_2", quantity(T.p2)},  {"P_3", quantity(ExactVec3(T.p1 + T.p2 - T.p0))},
                    {"\\vec u", quantity(u)}, {"\\vec v", quantity(v)},
                    {"\\vec n", quantity(n)}};
  if (vanishes(u))
    expected.vanished.insert("it.u");
  if (vanishes(v))
    expected.vanished.insert("it.v");
  if (!vanishes(n))
    return true;
  expected.degenerate = true;
  expected.vanished.insert("it.n");
  expected.caseName = T.p0 == T.p1 || T.p1 == T.p2 || T.p2 == T.p0 ? "coincident" : "collinear";
  return false;
}

Recomputed recompute(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const ExactVec3 P = objectAs<PointObject>(*objects[1])->at;
  Recomputed expected;
  const bool isTriangle = recomputeTriangle(T, expected);
  expected.names["P"] = quantity(P);
  if (!isTriangle)
    return expected;
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  const Rational d = -product(n, T.p0);
  expected.values["normal"] = numbers(n);
  expected.values["primitive"] = primitiveOf({n.x, n.y, n.z, d});
  const auto at = [](const ExactVec3 &point) {
    return Names{{"x", quantity(point.x)}, {"y", quantity(point.y)}, {"z", quantity(point.z)}};
  };
  expected.unknowns = at(somewhere);
  expected.solution = at(T.p1 * Rational(3) - T.p2 * Rational(2));
  // Cramer's rule for s·u + t·v + k·n = P − P0.
  const ExactVec3 w = P - T.p0;
  const Rational whole = determinant(u, v, n);
  expected.caseName = determinant(u, v, w) == 0 ? "in-plane" : "off-plane";
  if (expected.caseName == "off-plane")
    return expected;
  const Rational s = determinant(w, v, n) / whole;
  const Rational t = determinant(u, w, n) / whole;
  expected.names["s"] = quantity(s);
  expected.names["t"] = quantity(t);
  expected.values["s"] = number(s);
  expected.values["t"] = number(t);
  expected.values["point"] = numbers(P);
  expected.values["barycentric"] = numbers({Rational(1 - s - t), s, t});
  expected.values["in_parallelogram"] = s >= 0 && s <= 1 && t >= 0 && t <= 1 ? "yes" : "no";
  expected.values["more_of"] = s > t ? "s" : s < t ? "t" : "none";
  addLocation({Rational(1 - s - t), s, t}, expected);
  if (s == 0)
    expected.vanished.insert("it.su");
  if (t == 0)
    expected.vanished.insert("it.tv");
  return expected;
}

void addPoint(std::vector<WrongAnswer> &all, const TriangleObject &T, const ExactVec3 &P) {
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  const ExactVec3 su = u * Rational(determinant(ExactVec3(P - T.p0), v, n) / determinant(u, v, n));
  const ExactVec3 tv = P - T.p0 - su;
  addVector(all, "point", "the start forgotten", ExactVec3(su + tv), P);
  addVector(all, "point", "the part along u forgotten", ExactVec3(T.p0 + tv), P);
  addVector(all, "point", "the part along v forgotten", ExactVec3(T.p0 + su), P);
  addVector(all, "point", "the part along u subtracted", ExactVec3(T.p0 - su + tv), P);
  addVector(all, "point", "the part along v subtracted", ExactVec3(T.p0 + su - tv), P);
  addVector(all, "point", "u itself instead of s·u", ExactVec3(T.p0 + u + tv), P);
  addVector(all, "point", "the fourth corner", ExactVec3(T.p0 + u + v), P);
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const ExactVec3 P = objectAs<PointObject>(*objects[1])->at;
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
  addVector(all, "normal", "the other way round", ExactVec3(-n), n);
  addVector(all, "normal", "the second sign lost", {n.x, Rational(-n.y), n.z}, n);
  const Rational d = -times(n, T.p0);
  Line implicit("implicit", d, all, variablePart(n));
  for (const auto &[how, value] : dotSlips(n, T.p0))
    implicit.add(how, Rational(-value));
  if (product(n, ExactVec3(P - T.p0)) == 0)
    addPoint(all, T, P);
  Line check("check", Rational(times(n, P) + d), all);
  addSlips(check, differenceSlips(n, P, T.p0));
  return all;
}

} // namespace

namespace expected {

Expected plane_parametric() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
