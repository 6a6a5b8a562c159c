#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// The point's mirror image: as far behind its foot.
ExactVec3 imageOf(const ExactVec3 &point, const PlaneObject &plane) {
  return footOf(point, plane) * Rational(2) - point;
}

std::string caseOf(const PlaneObject &E, const RayObject &L) {
  const Rational atStart = product(E.normal, L.origin) - product(E.normal, E.point);
  const Rational slope = product(E.normal, L.direction);
  if (vanishes(E.normal))
    return "zero-normal";
  if (vanishes(L.direction))
    return "zero-direction";
  if (slope == 0)
    return atStart == 0 ? "in-plane" : "parallel";
  return atStart * slope > 0 ? "behind" : "hit";
}

Recomputed recompute(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const Rational slope = product(E.normal, L.direction);
  Recomputed expected;
  expected.caseName = caseOf(E, L);
  expected.values = {{"dot", number(slope)}};
  expected.names = {{"\\vec n", quantity(E.normal)},
                    {"P_0", quantity(E.point)},
                    {"Q_L", quantity(L.origin)},
                    {"\\vec r_L", quantity(L.direction)}};
  if (vanishes(E.normal))
    expected.vanished.insert("E.n");
  if (vanishes(L.direction))
    expected.vanished.insert("L.r");
  expected.degenerate = !expected.vanished.empty();
  if (slope == 0)
    return expected;
  const Rational t = (product(E.normal, E.point) - product(E.normal, L.origin)) / slope;
  expected.values["t"] = number(t);
  expected.names["t"] = quantity(t);
  if (expected.caseName != "hit")
    return expected;
  // From where it hits to the image of a point one step farther on.
  const ExactVec3 point = L.origin + L.direction * t;
  const ExactVec3 direction = imageOf(ExactVec3(point + L.direction), E) - point;
  expected.values["point"] = numbers(point);
  expected.values["direction"] = numbers(direction);
  expected.names["Q_R"] = quantity(point);
  expected.names["\\vec r_R"] = quantity(direction);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const auto E = objectAs<PlaneObject>(*objects[0]).value();
  const auto L = objectAs<RayObject>(*objects[1]).value();
  const ExactVec3 &n = E.normal;
  const ExactVec3 &r = L.direction;
  std::vector<WrongAnswer> all;
  if (vanishes(n) || vanishes(r))
    return all;
  addProduct(all, "dot", r, n);
  if (times(r, n) == 0)
    return all;
  addParameter(all, "t", n, E.point, L);
  if (caseOf(E, L) != "hit")
    return all;
  const Rational t = times(n, ExactVec3(E.point - L.origin)) / times(n, r);
  addPointOnRay(all, "start", L.origin, t, r);
  const ExactVec3 along = n * Rational(times(r, n) / times(n, n));
  const ExactVec3 right = r - along * Rational(2);
  addVector(all, "direction", "not turned at all", r, right);
  addVector(all, "direction", "turned round as a whole", ExactVec3(-r), right);
  addVector(all, "direction", "the factor 2 lost", ExactVec3(r - along), right);
  addVector(all, "direction", "added", ExactVec3(r + along * Rational(2)), right);
  addVector(all, "direction", "as if n had the length 1", ExactVec3(r - n * Rational(2 * times(r, n))),
            right);
  return all;
}

} // namespace

namespace expected {

Expected mirror_ray() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4};
}

} // namespace expected
} // namespace halfspace::test
