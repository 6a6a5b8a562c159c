#include "lessons/object/kinds/line.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// How two lines lie, by the arrow between their points and no moment.
struct Pair {
  explicit Pair(Objects objects)
      : g(objectAs<LineObject>(*objects[0]).value()), h(objectAs<LineObject>(*objects[1]).value()),
        between(h.point - g.point), common(perpendicular(g.direction, h.direction)),
        // The volume of the box of three arrows, with its sign turned.
        p(-determinant(between, g.direction, h.direction)) {}

  [[nodiscard]] bool isDegenerate() const { return vanishes(g.direction) || vanishes(h.direction); }
  [[nodiscard]] bool isCrossing() const { return !vanishes(common); }
  [[nodiscard]] std::string caseName() const {
    if (isDegenerate())
      return "not-a-line";
    if (isCrossing())
      return p == 0 ? "intersecting" : "skew";
    if (!vanishes(perpendicular(between, g.direction)))
      return "parallel";
    return product(g.direction, h.direction) > 0 ? "same" : "opposite";
  }
  [[nodiscard]] Rational distanceSquare() const {
    if (isCrossing())
      return p * p / product(common, common);
    const ExactVec3 across = perpendicular(between, g.direction);
    return product(across, across) / product(g.direction, g.direction);
  }
  /// Of the nearest points, by Cramer's rule for s·v_g − t·v_h + k·c = between.
  [[nodiscard]] std::pair<Rational, Rational> steps() const {
    const ExactVec3 back = h.direction * Rational(-1);
    const Rational whole = determinant(g.direction, back, common);
    return {determinant(between, back, common) / whole, determinant(g.direction, between, common) / whole};
  }

  LineObject g, h;
  ExactVec3 between, common;
  Rational p;
};

void addNearest(const Pair &pair, Recomputed &expected) {
  const auto [s, t] = pair.steps();
  const ExactVec3 first = pair.g.point + pair.g.direction * s;
  const ExactVec3 second = pair.h.point + pair.h.direction * t;
  expected.names["s"] = quantity(s);
  expected.names["t"] = quantity(t);
  expected.names["F"] = quantity(first);
  expected.names["G"] = quantity(second);
  if (pair.p == 0)
    expected.values["point"] = numbers(first);
}

Recomputed recompute(Objects objects) {
  const Pair pair(objects);
  const ExactVec3 m1 = perpendicular(pair.g.point, pair.g.direction);
  const ExactVec3 m2 = perpendicular(pair.h.point, pair.h.direction);
  Recomputed expected;
  expected.caseName = pair.caseName();
  expected.degenerate = pair.isDegenerate();
  expected.names = {{"A_g", quantity(pair.g.point)},
                    {"A_h", quantity(pair.h.point)},
                    {"\\vec v_g", quantity(pair.g.direction)},
                    {"\\vec v_h", quantity(pair.h.direction)},
                    {"\\vec m_g", quantity(m1)},
                    {"\\vec m_h", quantity(m2)},
                    {"\\vec c", quantity(pair.common)},
                    {"p", quantity(pair.p)},
                    {"T", quantity(Rational(abs(pair.p) / 6))}};
  for (const auto &[mark, vector] : {std::pair("g.v", pair.g.direction), std::pair("h.v", pair.h.direction),
                                     std::pair("it.m1", m1), std::pair("it.m2", m2)})
    if (vanishes(vector))
      expected.vanished.insert(mark);
  if (expected.degenerate)
    return expected;
  const Rational square = pair.distanceSquare();
  if (square == 0)
    expected.vanished.insert("it.dist");
  if (pair.p == 0)
    expected.vanished.insert("it.tetrahedron");
  expected.values = {{"product", number(pair.p)},
                     {"tetrahedron", number(abs(pair.p) / 6)},
                     {"perpendicular", product(pair.g.direction, pair.h.direction) == 0 ? "true" : "false"},
                     {"distance", SignedSquares{square}}};
  expected.names["\\operatorname{dist}"] =
      square == 0 ? quantity(Rational(0)) : quantityOverRoot(square, square);
  if (pair.isCrossing())
    addNearest(pair, expected);
  return expected;
}

void addPermuted(std::vector<WrongAnswer> &all, const Pair &pair) {
  const auto &[g, h] = std::tie(pair.g, pair.h);
  const ExactVec3 m1 = perpendicular(g.point, g.direction);
  const ExactVec3 m2 = perpendicular(h.point, h.direction);
  const Rational first = times(g.direction, m2);
  const Rational second = times(h.direction, m1);
  Line line("product", pair.p, all);
  line.add("only the first product", first);
  line.add("only the second product", second);
  line.add("subtracted", Rational(first - second));
  line.add("not crossed over", Rational(times(g.direction, h.direction) + times(m1, m2)));
  line.add("each with its own moment", Rational(times(g.direction, m1) + times(h.direction, m2)));
  line.add("the sign lost", Rational(-pair.p));
}

void addTetrahedron(std::vector<WrongAnswer> &all, const Pair &pair) {
  Line line("tetrahedron", Rational(abs(pair.p) / 6), all);
  addFraction(line, abs(pair.p), 6);
}

void addDistance(std::vector<WrongAnswer> &all, const Pair &pair) {
  const Rational square = times(pair.common, pair.common);
  const Rational magnitude = abs(pair.p);
  Line line("distance", Surd::root(pair.distanceSquare()), all);
  line.add("not divided", magnitude);
  line.addOverRoot("with the product's sign", Rational(-magnitude), square);
  line.addRatio("divided by c·c", magnitude, square);
  line.add("only the denominator", Surd::root(square));
}

void addSteps(std::vector<WrongAnswer> &all, const Pair &pair) {
  const Rational square = times(pair.common, pair.common);
  const auto [s, t] = pair.steps();
  for (const auto &[id, right] : {std::pair("s", s), std::pair("t", t)}) {
    Line line(id, right, all);
    addFraction(line, Rational(right * square), square);
  }
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Pair pair(objects);
  std::vector<WrongAnswer> all;
  if (pair.isDegenerate())
    return all;
  addProduct(all, "perpendicular", pair.g.direction, pair.h.direction);
  addPermuted(all, pair);
  addTetrahedron(all, pair);
  if (!pair.isCrossing())
    return all;
  addDistance(all, pair);
  addSteps(all, pair);
  return all;
}

} // namespace

namespace expected {

Expected line_line() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
