#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// number + factor·√square, whose sign is that of the factor.
struct Sum {
  Rational number;
  Rational factor;
  Rational square;

  [[nodiscard]] SumWithRoot told() const { return {number, Rational(factor * abs(factor) * square)}; }
  [[nodiscard]] Surd surd() const { return Surd::root(square, factor) + number; }
};

/// The coefficients of F with so many times those of E, each of which is as large as the root of a square.
std::array<Sum, 4> sumOf(const PlaneObject &F, const PlaneObject &E, const Rational &square, int sign) {
  const auto d = [](const PlaneObject &plane) { return Rational(-product(plane.normal, plane.point)); };
  std::array<Sum, 4> sums;
  for (int i = 0; i < 3; ++i)
    sums.at(static_cast<std::size_t>(i)) = {F.normal[i], Rational(E.normal[i] * sign), square};
  sums[3] = {d(F), Rational(d(E) * sign), square};
  return sums;
}

void expectBisector(const std::string &name, const std::array<Sum, 4> &sums, const ExactVec3 &point,
                    Recomputed &expected) {
  SumsWithRoots told;
  std::vector<Quantity> normal;
  for (const Sum &sum : sums) {
    told.push_back(sum.told());
    if (normal.size() < 3)
      normal.push_back(quantity(sum.surd()));
  }
  expected.values["coefficients_" + name] = told;
  expected.names["\\vec n_" + name] = together(normal);
  expected.names["P_{0," + name + "}"] = quantity(point);
  expected.names["d_" + name] = quantity(sums[3].surd());
}

/// A point of both planes: from that of E on, in E, until it lies in F; requires that they cross.
ExactVec3 pointOfBoth(const PlaneObject &E, const PlaneObject &F) {
  const ExactVec3 way = perpendicular(E.normal, perpendicular(E.normal, F.normal));
  return E.point + way * Rational(product(F.normal, ExactVec3(F.point - E.point)) / product(F.normal, way));
}

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto F = objectAs<PlaneObject>(*objects[1]).value();
  Recomputed expected;
  expected.names = {{"\\vec n_E", quantity(E.normal)},
                    {"\\vec n_F", quantity(F.normal)},
                    {"P_{0,E}", quantity(E.point)},
                    {"P_{0,F}", quantity(F.point)}};
  expected.names["d_E"] = quantity(Rational(-product(E.normal, E.point)));
  expected.names["d_F"] = quantity(Rational(-product(F.normal, F.point)));
  for (const auto &[name, plane] : {std::pair("E.n", E), std::pair("F.n", F)})
    if (vanishes(plane.normal))
      expected.vanished.insert(name);
  expected.degenerate = !expected.vanished.empty();
  if (expected.degenerate) {
    expected.caseName = "zero-normal";
    return expected;
  }
  const Rational square = product(F.normal, F.normal) / product(E.normal, E.normal);
  expected.values["ratio"] = SignedSquares{square};
  expected.names["k"] = quantityOverRoot(square, square);
  const ExactVec3 direction = perpendicular(E.normal, F.normal);
  expected.names["\\vec v"] = quantity(direction);
  expected.unknowns = coordinatesAt(somewhere);
  ExactVec3 point = (E.point + F.point) * Rational(1, 2);
  int sign = 1;
  if (vanishes(direction)) {
    if (product(E.normal, ExactVec3(F.point - E.point)) == 0) {
      expected.caseName = "coincident";
      return expected;
    }
    expected.caseName = "parallel";
    sign = product(E.normal, F.normal) < 0 ? -1 : 1;
  } else {
    expected.caseName = Surd::root(square).isRational() ? "crossing" : "irrational";
    point = pointOfBoth(E, F);
    // the part of it that is not along the line
    point = point - direction * Rational(product(point, direction) / product(direction, direction));
    expectBisector("H", sumOf(F, E, square, -1), point, expected);
  }
  expected.values["point"] = numbers(point);
  expected.solution = coordinatesAt(point);
  expectBisector("G", sumOf(F, E, square, sign), point, expected);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto F = objectAs<PlaneObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  const Rational ee = times(E.normal, E.normal);
  const Rational ff = times(F.normal, F.normal);
  if (ee == 0 || ff == 0)
    return all;
  for (const auto &[id, plane] : {std::pair("d1", E), std::pair("d2", F)}) {
    const Rational product = times(plane.normal, plane.point);
    Line line(id, Rational(-product), all);
    line.add("the minus forgotten", product);
    for (const auto &[how, value] : dotSlips(plane.normal, plane.point))
      line.add(how, Rational(-value));
  }
  Line ratio("ratio", Surd::root(Rational(ff / ee)), all);
  ratio.addRatio("the roots forgotten", ff, ee);
  ratio.add("upside down", Surd::root(Rational(ee / ff)));
  ratio.add("not divided", Surd::root(ff));
  ratio.add("multiplied", Surd::root(Rational(ee * ff)));
  return all;
}

} // namespace

namespace expected {

Expected plane_bisectors() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
