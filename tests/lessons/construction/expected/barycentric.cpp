#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

using Numbers = std::array<Rational, 3>;

/// ρ, σ and τ by s and t of the point, which solve two equations in dot products; and whether they lead to
/// the point.
struct Weights {
  Numbers all;
  bool lead = false;
};

Weights weightsOf(const TriangleObject &T, const ExactVec3 &Q) {
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 w = Q - T.p0;
  const Rational whole = product(u, u) * product(v, v) - product(u, v) * product(u, v);
  const Rational s = (product(w, u) * product(v, v) - product(w, v) * product(u, v)) / whole;
  const Rational t = (product(w, v) * product(u, u) - product(w, u) * product(u, v)) / whole;
  return {{Rational(1 - s - t), s, t}, vanishes(ExactVec3(w - u * s - v * t))};
}

std::string heaviestOf(const Numbers &weights) {
  for (std::size_t i = 0; i < 3; ++i)
    if (weights[i] > weights[(i + 1) % 3] && weights[i] > weights[(i + 2) % 3])
      return "P" + std::to_string(i);
  return "several";
}

void addLocation(const Numbers &weights, Recomputed &expected) {
  std::vector<int> zeros;
  int largest = 0;
  for (int i = 0; i < 3; ++i) {
    const Rational &weight = weights.at(static_cast<std::size_t>(i));
    if (weight == 0)
      zeros.push_back(i);
    if (weight > weights.at(static_cast<std::size_t>(largest)))
      largest = i;
    if (weight < 0)
      expected.caseName = "outside";
  }
  if (!expected.caseName.empty())
    return;
  expected.caseName = zeros.empty() ? "interior" : zeros.size() == 1 ? "edge" : "vertex";
  if (!zeros.empty())
    expected.values["feature"] = zeros.size() == 1 ? zeros.front() : largest;
}

/// What is left out of the figure because it has no extent.
std::set<std::string> vanishedFor(const Numbers &weights) {
  std::set<std::string> vanished;
  for (std::size_t i = 0; i < 3; ++i) {
    if (weights.at(i) == 0)
      vanished.insert({"it.A" + std::to_string(i), "it.n" + std::to_string(i)});
    if (weights.at(i) == 1 && weights.at((i + 2) % 3) == 0)
      vanished.insert("it.parallel" + std::to_string(i));
  }
  return vanished;
}

Recomputed recompute(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  const ExactVec3 n = perpendicular(ExactVec3(T.p1 - T.p0), ExactVec3(T.p2 - T.p0));
  const Rational square = product(n, n);
  Recomputed expected;
  expected.names = {{"P_0", quantity(T.p0)},
                    {"P_1", quantity(T.p1)},
                    {"P_2", quantity(T.p2)},
                    {"Q", quantity(Q)},
                    {"\\vec n", quantity(n)}};
  expected.values = {{"area", SignedSquares{Rational(square / 4)}}};
  if (vanishes(n)) {
    expected.names["A"] = quantity(Rational(0));
    expected.degenerate = true;
    expected.vanished = {"T", "it.n"};
    expected.caseName = T.p0 == T.p1 || T.p1 == T.p2 || T.p2 == T.p0 ? "coincident" : "collinear";
    return expected;
  }
  expected.names["A"] = quantityOverRoot(Rational(square / 2), square);
  const auto [weights, lead] = weightsOf(T, Q);
  if (!lead) {
    expected.caseName = "off-plane";
    return expected;
  }
  addLocation(weights, expected);
  expected.vanished = vanishedFor(weights);
  const auto &[rho, sigma, tau] = weights;
  SignedSquares areas;
  for (std::size_t i = 0; i < 3; ++i) {
    const Rational part = weights.at(i) * square / 2; // over the length of n
    areas.push_back(signedSquare(part, square));
    expected.names["A_" + std::to_string(i)] = quantityOverRoot(part, square);
  }
  expected.values["areas"] = areas;
  expected.values["barycentric"] = numbers({rho, sigma, tau});
  expected.values["heaviest"] = heaviestOf(weights);
  expected.names.insert({{"\\vec n_0", quantity(ExactVec3(n * rho))},
                         {"\\vec n_1", quantity(ExactVec3(n * sigma))},
                         {"\\vec n_2", quantity(ExactVec3(n * tau))},
                         {"\\rho", quantity(rho)},
                         {"\\sigma", quantity(sigma)},
                         {"\\tau", quantity(tau)},
                         {"B", quantity(ExactVec3(T.p1 + (T.p0 - T.p1) * rho))}});
  return expected;
}

/// Half the length of a normal, with a sign.
void addArea(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &normal, bool isNegative) {
  const Rational square = times(normal, normal);
  const Rational half(isNegative ? -1 : 1, 2);
  Line line(id, Surd::root(square, half), all);
  line.add("not halved", Surd::root(square, Rational(half * 2)));
  line.add("the sign lost", Surd::root(square, Rational(-half)));
  line.add("the root forgotten", Rational(square * half));
  line.add("doubled", Surd::root(square, Rational(half * 4)));
}

void addShare(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &part, const ExactVec3 &whole,
              const Rational &share, const Rational &other) {
  Line line(id, share, all);
  if (share != 0)
    line.add("upside down", Rational(1 / share));
  line.add("the sign lost", Rational(-share));
  line.add("not divided", Surd::root(times(part, part), Rational(share < 0 ? -1 : 1, 2)));
  line.add("only the whole", Surd::root(times(whole, whole), Rational(1, 2)));
  line.add("the other share", other);
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const ExactVec3 Q = objectAs<PointObject>(*objects[1])->at;
  const ExactVec3 n = perpendicular(ExactVec3(T.p1 - T.p0), ExactVec3(T.p2 - T.p0));
  std::vector<WrongAnswer> all;
  if (vanishes(n))
    return all;
  addArea(all, "area", n, false);
  const auto [weights, lead] = weightsOf(T, Q);
  if (!lead)
    return all;
  const auto &[rho, sigma, tau] = weights;
  const ExactVec3 n0 = n * rho;
  const ExactVec3 n1 = n * sigma;
  addArea(all, "area0", n0, rho < 0);
  addArea(all, "area1", n1, sigma < 0);
  addShare(all, "rho", n0, n, rho, sigma);
  addShare(all, "sigma", n1, n, sigma, rho);
  Line rest("area2", Surd::root(times(n, n), Rational(tau / 2)), all);
  rest.add("one part not taken off", Surd::root(times(n, n), Rational((tau + rho) / 2)));
  rest.add("the other part not taken off", Surd::root(times(n, n), Rational((tau + sigma) / 2)));
  rest.add("parts added up", Surd::root(times(n, n), Rational((rho + sigma) / 2)));
  Line last("tau", tau, all);
  last.add("not taken from 1", Rational(rho + sigma));
  last.add("one weight forgotten", Rational(1 - rho));
  last.add("the other weight forgotten", Rational(1 - sigma));
  last.add("one weight added", Rational(1 - rho + sigma));
  last.add("the sign lost", Rational(-tau));
  return all;
}

} // namespace

namespace expected {

Expected barycentric() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.5};
}

} // namespace expected
} // namespace halfspace::test
