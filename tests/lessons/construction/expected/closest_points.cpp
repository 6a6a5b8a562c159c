#include "lessons/object/kinds/line.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// Two lines, and the steps to their closest points by Cramer's rule for s·v_g − t·v_h + k·n = w.
struct Pair {
  explicit Pair(Objects objects)
      : g(objectAs<LineObject>(*objects[0]).value()), h(objectAs<LineObject>(*objects[1]).value()),
        w(h.point - g.point), n(perpendicular(g.direction, h.direction)),
        volume(abs(determinant(w, g.direction, h.direction))) {}

  [[nodiscard]] bool isDegenerate() const { return vanishes(g.direction) || vanishes(h.direction); }
  [[nodiscard]] bool hasPair() const { return !vanishes(n); }
  [[nodiscard]] std::string caseName() const {
    if (isDegenerate())
      return "zero-direction";
    if (hasPair())
      return volume == 0 ? "meet" : "skew";
    return vanishes(perpendicular(w, h.direction)) ? "coincident" : "parallel";
  }
  [[nodiscard]] Rational distanceSquare() const {
    if (hasPair())
      return volume * volume / product(n, n);
    const ExactVec3 across = perpendicular(w, h.direction);
    return product(across, across) / product(h.direction, h.direction);
  }
  [[nodiscard]] Rational s() const {
    const ExactVec3 back = h.direction * Rational(-1);
    return determinant(w, back, n) / determinant(g.direction, back, n);
  }
  [[nodiscard]] Rational t() const {
    const ExactVec3 back = h.direction * Rational(-1);
    return determinant(g.direction, w, n) / determinant(g.direction, back, n);
  }
  /// The foot of the first line's point on the second line, and the foot of that on the first.
  [[nodiscard]] ExactVec3 foot() const {
    return h.point - h.direction * Rational(product(w, h.direction) / product(h.direction, h.direction));
  }
  [[nodiscard]] ExactVec3 back() const {
    const ExactVec3 way = foot() - g.point;
    return g.point + g.direction * Rational(product(way, g.direction) / product(g.direction, g.direction));
  }

  LineObject g, h;
  ExactVec3 w, n;
  Rational volume;
};

void addPair(const Pair &pair, Recomputed &expected) {
  const Rational s = pair.s();
  const Rational t = pair.t();
  expected.values["s"] = number(s);
  expected.values["t"] = number(t);
  expected.names["s"] = quantity(s);
  expected.names["t"] = quantity(t);
  expected.names["F"] = quantity(ExactVec3(pair.g.point + pair.g.direction * s));
  expected.names["G"] = quantity(ExactVec3(pair.h.point + pair.h.direction * t));
  expected.solution = Names{{"s", quantity(s)}, {"t", quantity(t)}};
}

std::string backName(const Pair &pair) {
  const Rational gh = product(pair.g.direction, pair.h.direction);
  if (!pair.hasPair() || pair.s() == 0)
    return "start";
  return gh == 0 ? "closest" : "nearer";
}

void addVanished(const Pair &pair, Recomputed &expected) {
  for (const auto &[mark, vector] : {std::pair("g.v", pair.g.direction), std::pair("h.v", pair.h.direction),
                                     std::pair("it.w", pair.w), std::pair("it.n", pair.n)})
    if (vanishes(vector))
      expected.vanished.insert(mark);
  if (!pair.hasPair())
    expected.vanished.insert({"it.base", "it.box"});
}

Recomputed recompute(Objects objects) {
  const Pair pair(objects);
  Recomputed expected;
  expected.caseName = pair.caseName();
  expected.degenerate = pair.isDegenerate();
  expected.unknowns = {{"s", quantity(Rational(137, 11))}, {"t", quantity(Rational(-71, 13))}};
  expected.names = {{"A_g", quantity(pair.g.point)},
                    {"A_h", quantity(pair.h.point)},
                    {"\\vec v_g", quantity(pair.g.direction)},
                    {"\\vec v_h", quantity(pair.h.direction)},
                    {"\\vec w", quantity(pair.w)},
                    {"\\vec n", quantity(pair.n)},
                    {"V", quantity(pair.volume)}};
  addVanished(pair, expected);
  if (expected.degenerate)
    return expected;
  const Rational square = pair.distanceSquare();
  if (square == 0)
    expected.vanished.insert("it.dist");
  expected.values = {{"back", backName(pair)},
                     {"gh", number(product(pair.g.direction, pair.h.direction))},
                     {"hh", number(product(pair.h.direction, pair.h.direction))},
                     {"nn", number(product(pair.n, pair.n))},
                     {"distance", SignedSquares{square}},
                     {"volume", number(pair.volume)},
                     {"base", SignedSquares{product(pair.n, pair.n)}}};
  expected.names["H"] = quantity(pair.foot());
  expected.names["R"] = quantity(pair.back());
  expected.names["\\operatorname{dist}"] =
      square == 0 ? quantity(Rational(0)) : quantityOverRoot(square, square);
  if (pair.hasPair())
    addPair(pair, expected);
  else // each s has its t: at the line's own point, the foot of that
    expected.solution = Names{{"s", quantity(Rational(0))},
                              {"t", quantity(Rational(-product(pair.w, pair.h.direction) /
                                                      product(pair.h.direction, pair.h.direction)))}};
  return expected;
}

void addDeterminant(std::vector<WrongAnswer> &all, const Pair &pair) {
  const Rational falling =
      times(pair.g.direction, pair.g.direction) * times(pair.h.direction, pair.h.direction);
  const Rational gh = times(pair.g.direction, pair.h.direction);
  Line line("det", Rational(falling - gh * gh), all);
  line.add("only the diagonal that falls", falling);
  line.add("added", Rational(falling + gh * gh));
  line.add("the other way round", Rational(gh * gh - falling));
}

void addSteps(std::vector<WrongAnswer> &all, const Pair &pair) {
  const Rational square = times(pair.n, pair.n);
  for (const auto &[id, right] : {std::pair("s", pair.s()), std::pair("t", pair.t())}) {
    Line line(id, right, all);
    addFraction(line, Rational(right * square), square);
    line.addOverRoot("divided by |n|", Rational(right * square), square);
  }
}

void addDistance(std::vector<WrongAnswer> &all, const Pair &pair) {
  const Rational square = times(pair.n, pair.n);
  Line line("distance", Surd::root(pair.distanceSquare()), all);
  line.add("not divided", pair.volume);
  line.addOverRoot("with a sign", Rational(-pair.volume), square);
  line.addRatio("divided by n·n", pair.volume, square);
  line.add("only the denominator", Surd::root(square));
  line.add("the length of w", Surd::root(times(pair.w, pair.w)));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Pair pair(objects);
  std::vector<WrongAnswer> all;
  if (pair.isDegenerate())
    return all;
  addDeterminant(all, pair);
  if (!pair.hasPair())
    return all;
  addSteps(all, pair);
  addDistance(all, pair);
  addLength(all, "base", pair.n);
  addPointOnRay(all, "F", pair.g.point, pair.s(), pair.g.direction);
  addPointOnRay(all, "G", pair.h.point, pair.t(), pair.h.direction);
  return all;
}

} // namespace

namespace expected {

Expected closest_points() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.3};
}

} // namespace expected
} // namespace halfspace::test
