#include "lessons/object/kinds/sphere.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// How far the centre is from the plane, and the reach of the sphere beyond it, without a root.
struct Cut {
  Cut(const PlaneObject &E, const SphereObject &S)
      : foot(footOf(S.center, E)), way(S.center - foot), f(product(E.normal, ExactVec3(S.center - E.point))),
        distanceSquared(product(way, way)), rest(S.radius * S.radius - distanceSquared) {}

  ExactVec3 foot;
  ExactVec3 way;
  Rational f;
  Rational distanceSquared;
  Rational rest;
};

std::string caseOf(const Cut &cut) {
  return cut.rest < 0 ? "miss" : cut.rest == 0 ? "tangent" : vanishes(cut.way) ? "great-circle" : "circle";
}

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto S = objectAs<SphereObject>(*objects[1]).value();
  Recomputed expected;
  expected.names = {{"P_0", quantity(E.point)},
                    {"\\vec n", quantity(E.normal)},
                    {"c", quantity(S.center)},
                    {"R", quantity(S.radius)}};
  if (vanishes(E.normal))
    expected.vanished.insert("E.n");
  if (S.radius == 0)
    expected.vanished.insert("S");
  expected.degenerate = vanishes(E.normal) || S.radius == 0;
  if (expected.degenerate) {
    expected.caseName = S.radius == 0 ? "zero-radius" : "zero-normal";
    return expected;
  }
  const Cut cut(E, S);
  expected.caseName = caseOf(cut);
  expected.values = {{"f", number(cut.f)},
                     {"distance", SignedSquares{cut.distanceSquared}},
                     {"center", numbers(cut.foot)},
                     {"radius_squared", number(cut.rest)}};
  expected.names["f(c)"] = quantity(cut.f);
  expected.names["h"] = quantity(Surd::root(cut.distanceSquared));
  expected.names["M"] = quantity(cut.foot);
  expected.names["q"] = quantity(cut.rest);
  if (vanishes(cut.way))
    expected.vanished.insert("it.h");
  if (cut.rest > 0) {
    expected.values["radius"] = SignedSquares{cut.rest};
    expected.names["\\rho"] = quantity(Surd::root(cut.rest));
  }
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto S = objectAs<SphereObject>(*objects[1]).value();
  std::vector<WrongAnswer> all;
  if (vanishes(E.normal) || S.radius == 0)
    return all;
  const Cut cut(E, S);
  Line value("f", cut.f, all);
  addSlips(value, differenceSlips(E.normal, S.center, E.point));
  Line distance("h", Surd::root(cut.distanceSquared), all);
  distance.add("not divided", abs(cut.f));
  distance.addRatio("divided by the square", abs(cut.f), times(E.normal, E.normal));
  distance.add("the sign kept", -Surd::root(cut.distanceSquared));
  const Rational square = S.radius * S.radius;
  Line rest("square", cut.rest, all);
  rest.add("added", Rational(square + cut.distanceSquared));
  rest.add("the difference reversed", Rational(-cut.rest));
  rest.add("R not squared", Rational(S.radius - cut.distanceSquared));
  rest.add("h forgotten", square);
  if (cut.rest > 0) {
    Line radius("rho", Surd::root(cut.rest), all);
    radius.add("the root forgotten", cut.rest);
    radius.add("halved instead of the root taken", Rational(cut.rest / 2));
    radius.add("lengths subtracted", Surd::root(cut.distanceSquared, -1) + S.radius);
  }
  return all;
}

} // namespace

namespace expected {

Expected plane_sphere() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
