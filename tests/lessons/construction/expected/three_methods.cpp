#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// Six times the volumes that the ray's direction spans with two corners, seen from its start: those of the
/// edges opposite to the corners.
std::array<Rational, 3> volumesOf(const TriangleObject &T, const RayObject &L) {
  const std::array corners{T.p0, T.p1, T.p2};
  std::array<Rational, 3> volumes;
  for (std::size_t i = 0; i < 3; ++i)
    volumes[i] = determinant(L.direction, ExactVec3(corners[(i + 1) % 3] - L.origin),
                             ExactVec3(corners[(i + 2) % 3] - L.origin));
  return volumes;
}

Rational lambdaOf(const TriangleObject &T, const RayObject &L) {
  const ExactVec3 n = perpendicular(ExactVec3(T.p1 - T.p0), ExactVec3(T.p2 - T.p0));
  return product(n, ExactVec3(T.p0 - L.origin)) / product(n, L.direction);
}

void addMeeting(const std::array<Rational, 3> &volumes, const TriangleObject &T, const RayObject &L,
                Recomputed &expected) {
  const Rational whole = volumes[0] + volumes[1] + volumes[2];
  const Rational lambda = lambdaOf(T, L);
  const ExactVec3 point = L.origin + L.direction * lambda;
  std::array<Rational, 3> weights;
  std::vector<int> zeros;
  bool isOutside = false;
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = volumes[i] / whole;
    isOutside = isOutside || weights[i] < 0;
    if (weights[i] == 0)
      zeros.push_back(static_cast<int>(i));
  }
  expected.caseName = isOutside ? "miss" : lambda < 0 ? "behind" : "hit";
  expected.values["location"] = std::string(isOutside           ? "outside"
                                            : zeros.empty()     ? "interior"
                                            : zeros.size() == 1 ? "edge"
                                                                : "vertex");
  if (!isOutside && zeros.size() == 1)
    expected.values["feature"] = zeros[0];
  if (!isOutside && zeros.size() == 2)
    expected.values["feature"] = 3 - zeros[0] - zeros[1];
  expected.values["t"] = number(lambda);
  expected.values["point"] = numbers(point);
  expected.values["s"] = number(weights[1]);
  expected.values["t_triangle"] = number(weights[2]);
  expected.values["barycentric"] = numbers({weights[0], weights[1], weights[2]});
  const ExactVec3 w = point - T.p0;
  expected.names.insert({{"s", quantity(weights[1])},
                         {"t", quantity(weights[2])},
                         {"\\lambda", quantity(lambda)},
                         {"I", quantity(point)},
                         {"\\vec w", quantity(w)}});
  if (vanishes(w))
    expected.vanished.insert("it.w");
}

void addProducts(const std::array<Rational, 3> &volumes, const TriangleObject &T, const RayObject &L,
                 Recomputed &expected) {
  const auto [least, most] = std::minmax_element(volumes.begin(), volumes.end());
  expected.values["plucker.products"] = numbers({volumes[0], volumes[1], volumes[2]});
  expected.values["plucker.sum"] = number(Rational(volumes[0] + volumes[1] + volumes[2]));
  expected.values["plucker.signs"] = std::string(*least == 0 && *most == 0 ? "zero"
                                                 : *least < 0 && *most > 0 ? "mixed"
                                                                           : "same");
  expected.names["\\vec m"] = quantity(perpendicular(L.origin, L.direction));
  expected.names["\\vec e"] = quantity(ExactVec3(T.p2 - T.p1));
  expected.names["S"] = quantity(Rational(volumes[0] + volumes[1] + volumes[2]));
  const std::array corners{T.p0, T.p1, T.p2};
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactVec3 &from = corners[(i + 1) % 3];
    const ExactVec3 &to = corners[(i + 2) % 3];
    const std::string index = std::to_string(i);
    expected.names["p_" + index] = quantity(volumes[i]);
    expected.names["\\vec m_" + index] = quantity(perpendicular(from, ExactVec3(to - from)));
    if (from == to)
      expected.vanished.insert("it.p" + index);
  }
}

/// Counted by hand, from the formulas on paper: multiplications for a triangle and for each ray, additions,
/// divisions.
void addCosts(Recomputed &expected) {
  const auto add = [&](const char *way, const char *count, int once, int eachRay, int additions) {
    expected.values["cost." + std::string(way)] =
        SignedSquares{signedSquare(once), signedSquare(eachRay), signedSquare(additions), signedSquare(3)};
    expected.names[count] = quantity(Rational(once + eachRay));
  };
  add("perp", "N_1", 6 + 3 * 3 + 2, 3 * 3 + 2 * 3 + 2 * 2, 4 * 3 + 2 * 2 + 2 * 3 + 3 * 2 + 1 + 2 * 2 + 2);
  add("cramer", "N_2", 0, 2 * 6 + 4 * 3, 5 * 3 + 4 * 2);
  add("plucker", "N_3", 3 * 6, 6 + 3 * 6 + 3 * 3 + 2 * 3, 3 * 3 + 4 * 3 + 3 * 5 + 2 + 2 + 2 * 3 + 3 + 2 * 2);
}

Recomputed recompute(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 c = T.p0 - L.origin;
  const ExactVec3 &r = L.direction;
  const ExactVec3 n = perpendicular(u, v);
  const auto volumes = volumesOf(T, L);
  const Rational whole = product(r, n);
  const Rational last = product(c, n);
  Recomputed expected;
  expected.values = {{"perp.denominator", number(Rational(-product(n, n)))},
                     {"perp.along", number(whole)},
                     {"cramer.det", number(whole)},
                     {"cramer.det_sigma", number(volumes[1])},
                     {"cramer.det_tau", number(volumes[2])},
                     {"cramer.det_t", number(last)},
                     {"winding", std::string(whole > 0   ? "counterclockwise"
                                             : whole < 0 ? "clockwise"
                                                         : "none")}};
  expected.names = {{"P_0", quantity(T.p0)},
                    {"P_1", quantity(T.p1)},
                    {"P_2", quantity(T.p2)},
                    {"Q", quantity(L.origin)},
                    {"\\vec r", quantity(r)},
                    {"\\vec u", quantity(u)},
                    {"\\vec v", quantity(v)},
                    {"\\vec c", quantity(c)},
                    {"\\vec n", quantity(n)},
                    {"\\vec u^{\\perp}", quantity(perpendicular(n, u))},
                    {"\\vec v^{\\perp}", quantity(perpendicular(n, v))},
                    {"\\vec p", quantity(perpendicular(v, r))},
                    {"\\vec q", quantity(perpendicular(c, u))},
                    {"G", quantity(Rational(-product(n, n)))},
                    {"D", quantity(whole)},
                    {"D_1", quantity(volumes[1])},
                    {"D_2", quantity(volumes[2])},
                    {"D_3", quantity(last)}};
  addProducts(volumes, T, L, expected);
  addCosts(expected);
  for (const auto &[mark, vector] : {std::pair("L.r", r), {"it.u", u}, {"it.v", v}, {"it.c", c}})
    if (vanishes(vector))
      expected.vanished.insert(mark);
  if (vanishes(n)) {
    expected.vanished.insert({"it.n", "it.uperp", "it.vperp"});
    expected.degenerate = true;
    expected.caseName = T.p0 == T.p1 || T.p1 == T.p2 || T.p2 == T.p0 ? "coincident" : "collinear";
  } else if (whole != 0) {
    addMeeting(volumes, T, L, expected);
  } else {
    expected.caseName = vanishes(r) ? "zero-direction" : last == 0 ? "in-plane" : "parallel";
    expected.degenerate = vanishes(r);
  }
  return expected;
}

/// A dot product, perhaps with its sign turned.
void addDot(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &a, const ExactVec3 &b, int sign) {
  Line line(id, Rational(sign * times(a, b)), all);
  line.add("the sign lost", Rational(-sign * times(a, b)));
  for (const auto &[how, value] : dotSlips(a, b))
    line.add(how, Rational(sign * value));
}

/// r·m₂ + d·m of the ray and an edge.
void addProduct(std::vector<WrongAnswer> &all, const char *id, const Rational &first,
                const Rational &second) {
  Line line(id, Rational(first + second), all);
  line.add("only the first product", first);
  line.add("only the second product", second);
  line.add("subtracted", Rational(first - second));
  line.add("the sign lost", Rational(-first - second));
}

void addShare(std::vector<WrongAnswer> &all, const char *id, const Rational &top, const Rational &other,
              const Rational &bottom) {
  Line line(id, Rational(top / bottom), all);
  addFraction(line, top, bottom);
  line.addRatio("another determinant above", other, bottom);
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 c = T.p0 - L.origin;
  const ExactVec3 &r = L.direction;
  const ExactVec3 p = perpendicular(v, r);
  const ExactVec3 q = perpendicular(c, u);
  const ExactVec3 m = perpendicular(L.origin, r);
  std::vector<WrongAnswer> all;
  addDot(all, "D", u, p, 1);
  addDot(all, "D1", c, p, -1);
  addDot(all, "D2", r, q, 1);
  addDot(all, "D3", v, q, 1);
  addProduct(all, "p0", times(r, perpendicular(T.p1, T.p2)), times(m, ExactVec3(T.p2 - T.p1)));
  addProduct(all, "p1", times(r, perpendicular(T.p2, T.p0)), Rational(-times(m, v)));
  addProduct(all, "p2", times(r, perpendicular(T.p0, T.p1)), times(m, u));
  const Rational D = times(u, p);
  if (D == 0)
    return all;
  addShare(all, "cramer-s", Rational(-times(c, p)), times(r, q), D);
  addShare(all, "cramer-t", times(r, q), Rational(-times(c, p)), D);
  addShare(all, "cramer-lambda", times(v, q), Rational(-times(c, p)), D);
  Line lambda("perp-lambda", Rational(times(v, q) / D), all);
  addFraction(lambda, times(v, q), D);
  return all;
}

} // namespace

namespace expected {

Expected three_methods() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
