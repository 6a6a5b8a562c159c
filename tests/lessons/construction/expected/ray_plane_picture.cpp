#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// The foot of a point on the line through the origin along n.
ExactVec3 footOnNormal(const ExactVec3 &point, const ExactVec3 &n) {
  return footOf(ExactVec3(0), {point, n});
}

/// The points of the figure, each by a foot in a plane through another.
void addPoints(Recomputed &expected, const PlaneObject &G, const RayObject &L) {
  const ExactVec3 tip = L.origin + L.direction;
  const ExactVec3 A = footOnNormal(L.origin, G.normal);
  const ExactVec3 B = footOf(ExactVec3(0), G);
  const ExactVec3 C = footOf(L.origin, G);
  const ExactVec3 E = footOf(L.origin, {tip, G.normal});
  for (const auto &[letter, point] : {std::pair("O", ExactVec3(0)), std::pair("A", A), std::pair("B", B),
                                      std::pair("C", C), std::pair("E", E), std::pair("F", tip)})
    expected.names[letter] = quantity(point);
  if (vanishes(B))
    expected.vanished.insert("it.OB");
  if (vanishes(ExactVec3(C - L.origin)))
    expected.vanished.insert("it.QC");
  if (vanishes(ExactVec3(E - L.origin)))
    expected.vanished.insert("it.QE");
}

const char *caseWithoutHit(const PlaneObject &G, const RayObject &L, bool startsInPlane) {
  return vanishes(G.normal)      ? "zero-normal"
         : vanishes(L.direction) ? "zero-direction"
         : startsInPlane         ? "in-plane"
                                 : "parallel";
}

Recomputed recompute(Objects objects) {
  const auto G = objectAs<PlaneObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 &n = G.normal;
  const Rational D = product(G.point, n);
  const Rational atStart = product(n, L.origin) - D;
  const Rational slope = product(n, ExactVec3(L.origin + L.direction)) - D - atStart;
  Recomputed expected;
  expected.values = {{"D", number(D)},
                     {"numerator", number(Rational(-atStart))},
                     {"denominator", number(slope)},
                     {"length_n", SignedSquares{product(n, n)}}};
  if (!vanishes(n))
    expected.values["origin_way"] = D > 0 ? "with-n" : D < 0 ? "against-n" : "none";
  if (!vanishes(n) && !vanishes(L.direction))
    expected.values["normal"] = "none";
  expected.names = {{"\\vec n", quantity(n)},
                    {"\\vec r", quantity(L.direction)},
                    {"P_0", quantity(G.point)},
                    {"Q", quantity(L.origin)},
                    {"D", quantity(D)},
                    {"v_d", quantity(slope)},
                    {"v_0", quantity(Rational(-atStart))}};
  if (vanishes(n))
    expected.vanished = {"G.n", "it.OB", "it.QC", "it.QE"};
  else
    addPoints(expected, G, L);
  if (vanishes(L.direction))
    expected.vanished.insert("L.r");
  expected.degenerate = vanishes(n) || vanishes(L.direction);
  if (slope == 0) {
    expected.caseName = caseWithoutHit(G, L, atStart == 0);
    return expected;
  }
  // Where the plane's left side, which changes evenly along the ray, becomes zero.
  const Rational t = -atStart / slope;
  const ExactVec3 point = L.origin + L.direction * t;
  const ExactVec3 facing = slope > 0 ? ExactVec3(-n) : n;
  const Rational square = product(n, n);
  expected.caseName = t < 0 ? "behind" : "hit";
  expected.values["normal"] = slope > 0 ? "turned" : "kept";
  expected.values["t"] = number(t);
  expected.values["point"] = numbers(point);
  expected.values["facing_normal"] = normalizedNumbers(facing, square);
  expected.names["t"] = quantity(t);
  expected.names["H"] = quantity(point);
  expected.names["\\vec n_f"] = quantityOverRoot(facing, square);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto G = objectAs<PlaneObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  addProduct(all, "D", G.point, G.normal);
  addProduct(all, "vd", G.normal, L.direction);
  const Rational D = times(G.point, G.normal);
  const Rational start = times(G.normal, L.origin);
  Line v0("v0", Rational(D - start), all);
  v0.add("the difference the wrong way round", Rational(start - D));
  v0.add("added instead", Rational(D + start));
  v0.add("not subtracted", D);
  v0.add("the first number forgotten", Rational(-start));
  for (const auto &[how, value] : dotSlips(G.normal, L.origin))
    v0.add(how, Rational(D - value));
  const Rational slope = times(G.normal, L.direction);
  const Rational square = times(G.normal, G.normal);
  if (slope != 0) {
    Line t("t", Rational((D - start) / slope), all);
    addFraction(t, Rational(D - start), slope);
  }
  if (square == 0)
    return all;
  for (const auto &[id, top] :
       {std::pair("OB", D), std::pair("QE", slope), std::pair("QC", Rational(D - start))}) {
    Line length(id, Surd::root(square, Rational(abs(top) / square)), all);
    length.add("not divided", abs(top));
    length.addRatio("divided by n·n", abs(top), square);
    length.addOverRoot("the sign kept", top, square);
  }
  return all;
}

} // namespace

namespace expected {

Expected ray_plane_picture() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.5};
}

} // namespace expected
} // namespace halfspace::test
