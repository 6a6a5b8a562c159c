#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

struct Mirrored {
  explicit Mirrored(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), L(objectAs<RayObject>(*objects[1]).value()) {}

  bool isProper() const { return !vanishes(E.normal) && !vanishes(L.direction); }
  /// The foot of the direction in the plane through the origin.
  ExactVec3 across() const { return footOf(L.direction, {{0, 0, 0}, E.normal}); }

  PlaneObject E;
  RayObject L;
};

std::string caseOf(const Mirrored &at, const Rational &atStart, const Rational &slope) {
  if (vanishes(at.E.normal))
    return "zero-normal";
  if (vanishes(at.L.direction))
    return "zero-direction";
  if (slope == 0)
    return atStart == 0 ? "in-plane" : "parallel";
  return atStart * slope > 0 ? "behind" : "hit";
}

std::string wayOf(const std::string &caseName, const ExactVec3 &reflected) {
  if (caseName != "hit")
    return "none";
  return reflected.z > 0 ? "up" : reflected.z < 0 ? "down" : "level";
}

Recomputed recompute(Objects objects) {
  const Mirrored at(objects);
  const ExactVec3 &n = at.E.normal;
  const ExactVec3 &r = at.L.direction;
  const Rational atStart = product(n, at.L.origin) - product(n, at.E.point);
  const Rational slope = product(n, r);
  Recomputed expected;
  expected.caseName = caseOf(at, atStart, slope);
  expected.degenerate = !at.isProper();
  expected.values = {{"dot", number(slope)}, {"points", "none"}};
  expected.names = {{"\\vec n", quantity(n)},
                    {"\\vec r", quantity(r)},
                    {"P_0", quantity(at.E.point)},
                    {"Q", quantity(at.L.origin)}};
  if (vanishes(n))
    expected.vanished.insert("E.n");
  if (vanishes(r))
    expected.vanished.insert("L.r");
  if (!at.isProper())
    return expected;
  const ExactVec3 across = at.across();
  const ExactVec3 along = r - across;
  const ExactVec3 reflected = across * Rational(2) - r; // the two parts and their difference
  const Rational squares = product(n, n) * product(r, r);
  expected.values["points"] = wayOf(expected.caseName, reflected);
  expected.values["along"] = numbers(along);
  expected.values["across"] = numbers(across);
  expected.values["reflected"] = numbers(reflected);
  expected.values["turn"] = number(Rational(product(across, across) - product(along, along)));
  expected.values["cos_incidence"] = SignedSquares{signedSquare(Rational(-slope), squares)};
  expected.values["brightness"] = SignedSquares{signedSquare(abs(slope), squares)};
  expected.names["\\vec a"] = quantity(along);
  expected.names["\\vec h"] = quantity(across);
  expected.names["\\vec r'"] = quantity(reflected);
  expected.names["\\cos\\theta"] = quantityOverRoot(Rational(-slope), squares);
  expected.names["\\cos\\theta'"] = quantityOverRoot(Rational(-slope), squares);
  if (vanishes(across))
    expected.vanished.insert({"it.h", "it.theta", "it.thetaprime"});
  if (slope == 0)
    return expected;
  const Rational t = -atStart / slope;
  const ExactVec3 point = at.L.origin + r * t;
  expected.values["t"] = number(t);
  expected.values["point"] = numbers(point);
  expected.names["t"] = quantity(t);
  expected.names["H"] = quantity(point);
  return expected;
}

void addParts(std::vector<WrongAnswer> &all, const ExactVec3 &r, const ExactVec3 &n,
              const ExactVec3 &across) {
  const ExactVec3 along = r - across;
  addVector(all, "along", "as if n had the length 1", ExactVec3(n * times(r, n)), along);
  addVector(all, "along", "the sign lost", ExactVec3(-along), along);
  addVector(all, "along", "the projection of n", ExactVec3(r * Rational(times(r, n) / times(r, r))), along);
  addVector(all, "along", "the part across", across, along);
  addVector(all, "along", "the direction scaled", ExactVec3(r * Rational(times(r, n) / times(n, n))), along);
  addVector(all, "across", "the difference reversed", ExactVec3(-across), across);
  addVector(all, "across", "added", ExactVec3(r + along), across);
}

void addReflected(std::vector<WrongAnswer> &all, const char *id, const ExactVec3 &r, const ExactVec3 &n,
                  const ExactVec3 &across) {
  const ExactVec3 along = r - across;
  const ExactVec3 right = across - along;
  addVector(all, id, "not turned at all", r, right);
  addVector(all, id, "turned round as a whole", ExactVec3(-r), right);
  addVector(all, id, "the part across turned round", ExactVec3(along - across), right);
  if (std::string_view(id) == "turned")
    return;
  addVector(all, id, "the factor 2 lost", across, right);
  addVector(all, id, "added", ExactVec3(r + along * Rational(2)), right);
  addVector(all, id, "as if n had the length 1", ExactVec3(r - n * Rational(2 * times(r, n))), right);
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Mirrored at(objects);
  std::vector<WrongAnswer> all;
  if (!at.isProper())
    return all;
  const ExactVec3 &n = at.E.normal;
  const ExactVec3 &r = at.L.direction;
  const ExactVec3 across = at.across();
  addProduct(all, "dot", r, n);
  addParts(all, r, n, across);
  addReflected(all, "turned", r, n, across);
  addReflected(all, "reflected", r, n, across);
  addCosine(all, ExactVec3(-r), n, "incidence");
  addCosine(all, ExactVec3(across * Rational(2) - r), n, "departure");
  if (times(r, n) == 0)
    return all;
  addParameter(all, "t", n, at.E.point, at.L);
  const Rational squares = times(n, n) * times(r, r);
  Line brightness("brightness", Surd::root(squares, Rational(abs(times(r, n)) / squares)), all);
  brightness.add("not divided", abs(times(r, n)));
  brightness.addOverRoot("divided by |n| only", abs(times(r, n)), times(n, n));
  brightness.addOverRoot("divided by |r| only", abs(times(r, n)), times(r, r));
  brightness.addOverRoot("with a sign", Rational(-abs(times(r, n))), squares);
  brightness.addRatio("divided by the squares of both lengths", abs(times(r, n)), squares);
  return all;
}

} // namespace

namespace expected {

Expected reflection() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.65};
}

} // namespace expected
} // namespace halfspace::test
