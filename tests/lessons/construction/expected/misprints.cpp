#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

std::string verdict(bool holds) { return holds ? "holds" : "fails"; }

/// What belongs to the triangle's plane: n, d, the distance, the feet. By n·x = d.
void addPlane(const TriangleObject &T, const RayObject &L, const ExactVec3 &n, Recomputed &expected) {
  const Rational d = determinant(T.p0, T.p1, T.p2);
  const ExactVec3 &Q = L.origin;
  const Rational f = product(n, Q) - d;
  const Rational printed = d - n.x * Q.x + n.y * Q.y + n.z * Q.z;
  const PlaneObject plane{T.p0, n};
  expected.values["f"] = number(f);
  expected.values["printed_f"] = number(printed);
  expected.values["D"] = number(d);
  expected.values["distance"] = verdict(printed - f == 0);
  if (d != 0)
    expected.values["direction"] = verdict(d > 0);
  else
    expected.vanished.insert("it.B/way");
  expected.names.insert({{"D", quantity(d)},
                         {"f", quantity(f)},
                         {"h", quantity(printed)},
                         {"a", quantity(n.x)},
                         {"b", quantity(n.y)},
                         {"c", quantity(n.z)},
                         {"Q_x", quantity(Q.x)},
                         {"Q_y", quantity(Q.y)},
                         {"Q_z", quantity(Q.z)},
                         {"F", quantity(footOf(Q, plane))},
                         {"B", quantity(footOf(ExactVec3(0, 0, 0), plane))},
                         {"O", quantity(ExactVec3(0, 0, 0))}});
}

/// Where the line of the ray goes through the plane, by areas.
void addMeeting(const TriangleObject &T, const RayObject &L, const ExactVec3 &n, Recomputed &expected) {
  const Rational along = product(n, L.direction);
  const Rational lambda = product(n, ExactVec3(T.p0 - L.origin)) / along;
  const ExactVec3 point = L.origin + L.direction * lambda;
  const std::array corners{T.p0, T.p1, T.p2};
  std::array<Rational, 3> weights;
  std::vector<int> zeros;
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactVec3 &from = corners[(i + 1) % 3];
    weights[i] =
        determinant(n, ExactVec3(corners[(i + 2) % 3] - from), ExactVec3(point - from)) / product(n, n);
    if (weights[i] == 0)
      zeros.push_back(static_cast<int>(i));
  }
  const bool isOutside = std::any_of(weights.begin(), weights.end(), [](const auto &w) { return w < 0; });
  const bool isCorner = zeros.size() == 2;
  expected.caseName = isOutside ? "miss" : lambda < 0 ? "behind" : "hit";
  expected.values["location"] = std::string(isOutside       ? "outside"
                                            : zeros.empty() ? "interior"
                                            : isCorner      ? "vertex"
                                                            : "edge");
  if (!isOutside && !zeros.empty())
    expected.values["feature"] = isCorner ? 3 - zeros[0] - zeros[1] : zeros[0];
  expected.values["perimeter"] = verdict(zeros.empty() || !isOutside);
  expected.values["vertex"] = verdict(!isCorner);
  expected.values["start"] = verdict(expected.caseName != "behind");
  expected.values["facing"] = verdict(along < 0);
  expected.values["t"] = number(lambda);
  expected.values["point"] = numbers(point);
  expected.values["s"] = number(weights[1]);
  expected.values["t_triangle"] = number(weights[2]);
  expected.values["denominator"] = number(along);
  expected.names.insert({{"s", quantity(weights[1])},
                         {"t", quantity(weights[2])},
                         {"\\lambda", quantity(lambda)},
                         {"I", quantity(point)},
                         {"\\vec N", quantity(along > 0 ? ExactVec3(-n) : n)}});
}

void addAngle(const ExactVec3 &u, const ExactVec3 &v, Recomputed &expected) {
  const Rational uv = product(u, v);
  const Rational squares = product(u, u) * product(v, v);
  expected.values["cos_angle"] = SignedSquares{signedSquare(uv, squares)};
  expected.values["cosine"] = verdict(uv * uv != squares || uv > 0);
  expected.names["\\cos\\theta"] = quantityOverRoot(uv, squares);
}

Recomputed recompute(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 &r = L.direction;
  const ExactVec3 n = perpendicular(u, v);
  const ExactVec3 perp = perpendicular(n, u);
  const ExactVec3 printed = (v - u) * product(u, v);
  Recomputed expected;
  expected.values = {
      {"triple", verdict(perp == printed)}, {"printed_perp", numbers(printed)}, {"u_perp", numbers(perp)}};
  expected.names = {{"P_0", quantity(T.p0)},        {"P_1", quantity(T.p1)},
                    {"P_2", quantity(T.p2)},        {"Q", quantity(L.origin)},
                    {"\\vec r", quantity(r)},       {"\\vec u", quantity(u)},
                    {"\\vec v", quantity(v)},       {"\\vec n", quantity(n)},
                    {"\\vec k", quantity(printed)}, {"\\vec u^{\\perp}", quantity(perp)}};
  for (const auto &[mark, vector] :
       {std::pair("L.r", r), {"it.u", u}, {"it.v", v}, {"it.uperp", perp}, {"it.k", printed}})
    if (vanishes(vector))
      expected.vanished.insert(mark);
  if (!vanishes(u) && !vanishes(v))
    addAngle(u, v, expected);
  const bool isCoincident = T.p0 == T.p1 || T.p1 == T.p2 || T.p2 == T.p0;
  expected.degenerate = vanishes(n) || vanishes(r);
  if (vanishes(n)) {
    expected.caseName = isCoincident ? "coincident" : "collinear";
    return expected;
  }
  addPlane(T, L, n, expected);
  if (product(n, r) != 0)
    addMeeting(T, L, n, expected);
  else
    expected.caseName = vanishes(r)                                   ? "zero-direction"
                        : product(n, ExactVec3(T.p0 - L.origin)) == 0 ? "in-plane"
                                                                      : "parallel";
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  std::vector<WrongAnswer> all;
  if (vanishes(n))
    return all;
  addCosine(all, u, v);
  addProduct(all, "D", n, T.p0);
  Line distance("distance-right", times(n, ExactVec3(L.origin - T.p0)), all);
  distance.add("the sign lost", times(n, ExactVec3(T.p0 - L.origin)));
  if (times(n, L.direction) == 0)
    return all;
  addProduct(all, "facing", n, L.direction);
  addParameter(all, "lambda", n, T.p0, L);
  return all;
}

} // namespace

namespace expected {

Expected misprints() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
