#include "lessons/object/kinds/plane.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 &n = E.normal;
  // The equation's left side at the origin and one step along each axis tells its coefficients.
  const auto leftSide = [&](const ExactVec3 &x) { return product(n, ExactVec3(x - E.point)); };
  const Rational d = leftSide({0, 0, 0});
  const std::array<Rational, 4> all{leftSide({1, 0, 0}) - d, leftSide({0, 1, 0}) - d, leftSide({0, 0, 1}) - d,
                                    d};
  Recomputed expected;
  SignedSquares coefficients;
  for (const Rational &each : all)
    coefficients.push_back(signedSquare(each));
  expected.values["coefficients"] = coefficients;
  expected.names = {{"\\vec n", quantity(n)}, {"P_0", quantity(E.point)}};
  expected.unknowns = coordinatesAt(somewhere);
  expected.degenerate = vanishes(n);
  expected.caseName = vanishes(n) ? "zero-normal" : "plane";
  expected.solution = coordinatesAt(vanishes(n) ? somewhere : footOf(somewhere, E));
  if (vanishes(n)) {
    expected.vanished = {"E.n"};
    return expected;
  }
  const Rational square = product(n, n);
  SignedSquares normalized = normalizedNumbers(n, square);
  normalized.push_back(signedSquare(d, square));
  expected.values["primitive"] = primitiveOf(all);
  expected.values["normalized"] = normalized;
  expected.values["origin_distance"] = SignedSquares{signedSquare(d, square)};
  // Which second point the program shows is its choice; that it lies in the plane is what its line says.
  const ExactVec3 along = n.y == 0 && n.z == 0 ? ExactVec3{0, 2, 0} : ExactVec3{0, n.z, Rational(-n.y)};
  expected.names["P_1"] = quantity(ExactVec3(E.point + along));
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const ExactVec3 &n = E.normal;
  const Rational square = times(n, n);
  std::vector<WrongAnswer> all;
  if (square == 0)
    return all;
  const Rational d = -times(n, E.point);
  Line collect("collect", d, all, variablePart(n));
  for (const auto &[how, value] : dotSlips(n, E.point))
    collect.add(how, Rational(-value));
  for (const auto &[how, value] : dotSlips(n, E.point))
    collect.add("the minus lost, and more", value);
  collect.add("only P0 added up", coordinateSum(E.point));
  collect.add("P0 added up and subtracted", Rational(-coordinateSum(E.point)));
  collect.addOverRoot("normalized too early", d, square);
  // Any second point will do: the number is the same. The program's own is not known here.
  const ExactVec3 along = n.y == 0 && n.z == 0 ? ExactVec3{0, 2, 0} : ExactVec3{0, n.z, Rational(-n.y)};
  addProduct(all, "constant", n, ExactVec3(E.point + along));
  Line normalized("normalized", Surd::root(square, Rational(d / square)), all,
                  "(" + variablePart(n) + ")/sqrt(" + toText(square) + ")");
  normalized.add("not divided", d);
  normalized.addOverRoot("the sign lost", Rational(-d), square);
  normalized.addRatio("divided by n·n", d, square);
  normalized.addRatio("divided by the coordinates' sum", d, coordinateSum(n));
  normalized.add("multiplied instead of divided", Surd::root(square, d));
  normalized.add("only the length", Surd::root(square));
  if (d != 0)
    normalized.add("upside down", Surd::root(square, Rational(1 / d)));
  for (const auto &[how, value] : dotSlips(n, E.point))
    if (std::string_view(how) == "one product dropped")
      normalized.addOverRoot("in d: one product dropped", Rational(-value), square);
  return all;
}

} // namespace

namespace expected {

Expected plane_implicit() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.32};
}

} // namespace expected
} // namespace halfspace::test
