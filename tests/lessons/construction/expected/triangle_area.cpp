#include "lessons/object/kinds/triangle.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

Rational squareOf(const ExactVec3 &way) { return product(way, way); }

/// By the sides alone (Heron): 16 times the square of the area, of their squares.
Rational heron(const TriangleObject &T) {
  const Rational a = squareOf(T.p1 - T.p0);
  const Rational b = squareOf(T.p2 - T.p1);
  const Rational c = squareOf(T.p0 - T.p2);
  return 2 * (a * b + b * c + c * a) - (a * a + b * b + c * c);
}

Recomputed recompute(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  const ExactVec3 u = T.p1 - T.p0;
  const ExactVec3 v = T.p2 - T.p0;
  const ExactVec3 n = perpendicular(u, v);
  const Rational square = heron(T) / 16;
  Recomputed expected;
  expected.names = {{"P_0", quantity(T.p0)},
                    {"P_1", quantity(T.p1)},
                    {"P_2", quantity(T.p2)},
                    {"\\vec u", quantity(u)},
                    {"\\vec v", quantity(v)},
                    {"\\vec n", quantity(n)},
                    {"A", quantity(Surd::root(square))}};
  expected.values = {{"normal", numbers(n)}, {"area", SignedSquares{square}}};
  expected.degenerate = square == 0;
  const bool areApart = T.p0 != T.p1 && T.p1 != T.p2 && T.p2 != T.p0;
  expected.caseName = square != 0 ? "proper" : areApart ? "collinear" : "coincident";
  if (vanishes(u))
    expected.vanished.insert("it.u");
  if (vanishes(v))
    expected.vanished.insert("it.v");
  if (square == 0) {
    expected.vanished.insert({"it.n", "it.h", "T"});
    return expected;
  }
  // The way from P2 to its foot on the line of u.
  const ExactVec3 height = v - u * Rational(product(u, v) / product(u, u));
  expected.values["height"] = SignedSquares{squareOf(height)};
  expected.names["h"] = quantity(Surd::root(squareOf(height)));
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto T = objectAs<TriangleObject>(*objects[0]).value();
  std::vector<WrongAnswer> all;
  const Rational square = heron(T) / 4; // of the parallelogram
  if (square == 0)
    return all;
  const ExactVec3 u = T.p1 - T.p0;
  addVector(all, "u", "backwards", -u, u);
  addCross(all, "normal", u, ExactVec3(T.p2 - T.p0));
  Line area("area", Surd::root(Rational(square / 4)), all);
  area.add("not halved", Surd::root(square));
  area.add("the root forgotten", Rational(square / 2));
  area.add("a third", Surd::root(Rational(square / 9)));
  Line height("height", Surd::root(Rational(square / squareOf(u))), all);
  height.add("the triangle's area divided", Surd::root(Rational(square / 4 / squareOf(u))));
  height.add("divided by the square", Surd::root(Rational(square / (squareOf(u) * squareOf(u)))));
  height.add("not divided", Surd::root(square));
  Line byHeight("by-height", Surd::root(Rational(square / 4)), all);
  byHeight.add("not halved", Surd::root(square));
  return all;
}

} // namespace

namespace expected {

Expected triangle_area() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
