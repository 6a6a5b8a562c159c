#include "lessons/object/kinds/ray.h"
#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// Where the line of the ray meets the plane, by perpendiculars: the plane's equation for λ, and areas for
/// the weights.
struct Meeting {
  Rational lambda;
  ExactVec3 point;
  std::array<Rational, 3> weights;
};

Meeting meetingOf(const TriangleObject &T, const RayObject &L) {
  const ExactVec3 n = perpendicular(ExactVec3(T.p1 - T.p0), ExactVec3(T.p2 - T.p0));
  Meeting meeting;
  meeting.lambda = product(n, ExactVec3(T.p0 - L.origin)) / product(n, L.direction);
  meeting.point = L.origin + L.direction * meeting.lambda;
  const std::array corners{T.p0, T.p1, T.p2};
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactVec3 &from = corners[(i + 1) % 3];
    meeting.weights[i] =
        determinant(n, ExactVec3(corners[(i + 2) % 3] - from), ExactVec3(meeting.point - from)) /
        product(n, n);
  }
  return meeting;
}

void addMeeting(const Meeting &meeting, Recomputed &expected) {
  const auto &weights = meeting.weights;
  int zeros = 0;
  int lastZero = 0;
  int largest = 0;
  bool isOutside = false;
  for (int i = 0; i < 3; ++i) {
    const Rational &weight = weights.at(static_cast<std::size_t>(i));
    isOutside = isOutside || weight < 0;
    if (weight == 0) {
      ++zeros;
      lastZero = i;
    }
    if (weight > weights.at(static_cast<std::size_t>(largest)))
      largest = i;
  }
  expected.caseName = isOutside ? "miss" : meeting.lambda < 0 ? "behind" : "hit";
  expected.values["location"] = std::string(isOutside    ? "outside"
                                            : zeros == 0 ? "interior"
                                            : zeros == 1 ? "edge"
                                                         : "vertex");
  if (!isOutside && zeros > 0)
    expected.values["feature"] = zeros == 1 ? lastZero : largest;
  expected.values["t"] = number(meeting.lambda);
  expected.values["point"] = numbers(meeting.point);
  expected.values["barycentric"] = numbers({weights[0], weights[1], weights[2]});
  expected.names.insert({{"\\sigma", quantity(weights[1])},
                         {"\\tau", quantity(weights[2])},
                         {"\\lambda", quantity(meeting.lambda)},
                         {"I", quantity(meeting.point)}});
}

Recomputed recompute(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 a = T.p0 - T.p1;
  const ExactVec3 b = T.p0 - T.p2;
  const ExactVec3 c = T.p0 - L.origin;
  const ExactVec3 &r = L.direction;
  const std::array determinants{determinant(a, b, r), determinant(c, b, r), determinant(a, c, r),
                                determinant(a, b, c)};
  Recomputed expected;
  expected.values = {{"cramer.det", number(determinants[0])},
                     {"cramer.det_sigma", number(determinants[1])},
                     {"cramer.det_tau", number(determinants[2])},
                     {"cramer.det_t", number(determinants[3])}};
  expected.names = {{"P_0", quantity(T.p0)},
                    {"P_1", quantity(T.p1)},
                    {"P_2", quantity(T.p2)},
                    {"Q", quantity(L.origin)},
                    {"\\vec r", quantity(r)},
                    {"\\vec a", quantity(a)},
                    {"\\vec b", quantity(b)},
                    {"\\vec c", quantity(c)},
                    {"\\vec p", quantity(perpendicular(b, r))},
                    {"\\vec q", quantity(perpendicular(a, c))},
                    {"D", quantity(determinants[0])},
                    {"D_1", quantity(determinants[1])},
                    {"D_2", quantity(determinants[2])},
                    {"D_3", quantity(determinants[3])}};
  if (vanishes(perpendicular(b, r)))
    expected.vanished.insert("it.p");
  if (vanishes(perpendicular(a, c)))
    expected.vanished.insert("it.q");
  if (vanishes(r)) {
    expected.vanished.insert("L.r");
    expected.degenerate = true;
  }
  if (vanishes(perpendicular(a, b))) {
    expected.degenerate = true;
    expected.caseName = T.p0 == T.p1 || T.p1 == T.p2 || T.p2 == T.p0 ? "coincident" : "collinear";
  } else if (determinants[0] != 0) {
    addMeeting(meetingOf(T, L), expected);
    const ExactVec3 p = perpendicular(b, r);
    expected.names["h_a"] = quantityOverRoot(determinants[0], product(p, p));
    expected.names["h_c"] = quantityOverRoot(determinants[1], product(p, p));
    if (determinants[1] == 0)
      expected.vanished.insert("it.hc");
  } else {
    expected.caseName = vanishes(r) ? "zero-direction" : determinants[3] == 0 ? "in-plane" : "parallel";
  }
  return expected;
}

/// A determinant that is a dot product of a column with a cross product; the sign of the middle column is −1.
void addDeterminant(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &column,
                    const ExactVec3 &shared, int sign) {
  Line line(id, Rational(sign * times(column, shared)), all);
  for (const auto &[how, value] : dotSlips(column, shared))
    line.add(how, Rational(sign * value));
}

/// By cofactors of the first column.
void addExpansion(std::vector<WrongAnswer> &all, const ExactVec3 &column, const ExactVec3 &minors) {
  const auto products = productsOf(column, minors);
  const Rational right = total(products);
  Line line("expansion", right, all);
  line.add("the middle sign forgotten", Rational(right - 2 * products[1]));
  line.add("the last part subtracted", Rational(right - 2 * products[2]));
  line.add("all signs turned", Rational(-right));
  for (const Rational &product : products)
    line.add("one part dropped", Rational(right - product));
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
  const ExactVec3 a = T.p0 - T.p1;
  const ExactVec3 b = T.p0 - T.p2;
  const ExactVec3 c = T.p0 - L.origin;
  const ExactVec3 p = perpendicular(b, L.direction);
  const ExactVec3 q = perpendicular(a, c);
  std::vector<WrongAnswer> all;
  addExpansion(all, a, p);
  addDeterminant(all, "det", a, p, 1);
  addDeterminant(all, "det-sigma", c, p, 1);
  addDeterminant(all, "det-tau", L.direction, q, 1);
  addDeterminant(all, "det-t", b, q, -1);
  const Rational D = times(a, p);
  if (D == 0)
    return all;
  addShare(all, "sigma", times(c, p), times(L.direction, q), D);
  addShare(all, "tau", times(L.direction, q), times(c, p), D);
  addShare(all, "t", Rational(-times(b, q)), times(c, p), D);
  return all;
}

} // namespace

namespace expected {

Expected ray_triangle_cramer() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
