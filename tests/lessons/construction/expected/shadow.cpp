#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "lessons/object/kinds/vector.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// By heights over the plane, times |n|: light that sinks by so much with each step.
struct LitTriangle {
  explicit LitTriangle(Objects objects)
      : E(objectAs<PlaneObject>(*objects[0]).value()), Q(objectAs<PointObject>(*objects[1])->at),
        r(objectAs<VectorObject>(*objects[5]).value()), sinks(-product(E.normal, r.vector)),
        lampHeight(heightOf(Q)) {
    for (std::size_t i = 0; i < 3; ++i)
      at.at(i) = objectAs<PointObject>(*objects[i + 2])->at;
    at[3] = at[0] + ExactVec3(at[1] - at[0]) / Rational(2);
    for (std::size_t i = 0; i < at.size(); ++i)
      height.at(i) = heightOf(at.at(i));
  }

  Rational heightOf(const ExactVec3 &point) const {
    return product(E.normal, point) - product(E.normal, E.point);
  }
  bool isPlane() const { return !vanishes(E.normal); }
  bool isSun() const { return isPlane() && !vanishes(r.vector); }
  bool isLevel(std::size_t i) const { return height.at(i) == lampHeight; }
  Rational sunSteps(std::size_t i) const { return height.at(i) / sinks; }
  Rational lampSteps(std::size_t i) const { return lampHeight / (lampHeight - height.at(i)); }
  /// What is left of a point when its height is taken off along the light.
  ExactVec3 sunPlace(std::size_t i) const { return (at.at(i) * sinks + r.vector * height.at(i)) / sinks; }
  /// Lamp and point, weighted by the height of the other.
  ExactVec3 lampPlace(std::size_t i) const {
    return (at.at(i) * lampHeight - Q * height.at(i)) / Rational(lampHeight - height.at(i));
  }
  bool isSunny(std::size_t i) const { return sinks != 0 && height.at(i) * sinks >= 0; }
  bool isLampLit(std::size_t i) const {
    return lampHeight > 0 ? height.at(i) >= 0 && height.at(i) < lampHeight
                          : height.at(i) <= 0 && height.at(i) > lampHeight;
  }
  bool hasPart() const { return isPlane() && lampHeight != 0 && !isLevel(0) && !isLevel(1) && !isLevel(3); }
  Rational depth(std::size_t i) const { return lampHeight - height.at(i); }

  PlaneObject E;
  ExactVec3 Q;
  VectorObject r;
  std::array<ExactVec3, 4> at;
  std::array<Rational, 4> height;
  Rational sinks;
  Rational lampHeight;
};

bool isSunny(const LitTriangle &lit) { return lit.isSunny(0) && lit.isSunny(1) && lit.isSunny(2); }
bool isLampLit(const LitTriangle &lit) {
  return lit.isPlane() && lit.isLampLit(0) && lit.isLampLit(1) && lit.isLampLit(2);
}

std::string caseOf(const LitTriangle &lit) {
  if (!lit.isPlane())
    return "zero-normal";
  if (!lit.isSun())
    return "no-sunlight";
  return isSunny(lit) ? (isLampLit(lit) ? "both" : "sun") : isLampLit(lit) ? "lamp" : "neither";
}

std::string lampWord(const LitTriangle &lit, std::size_t i) {
  if (lit.at.at(i) == lit.Q)
    return "at-lamp";
  if (lit.isLevel(i))
    return "parallel";
  if (lit.isLampLit(i))
    return "falls";
  return lit.lampHeight * lit.height.at(i) > 0 ? "away" : "plane-first";
}

std::string shapeOf(bool falls, const ExactVec3 &a, const ExactVec3 &b, const ExactVec3 &c) {
  if (!falls)
    return "none";
  return vanishes(perpendicular(ExactVec3(b - a), ExactVec3(c - a))) ? "flat" : "triangle";
}

/// By the distances of the places themselves.
std::string nearerOf(const LitTriangle &lit) {
  if (!lit.hasPart() || lit.lampPlace(0) == lit.lampPlace(1))
    return "none";
  const ExactVec3 toA = lit.lampPlace(0) - lit.lampPlace(3);
  const ExactVec3 toB = lit.lampPlace(1) - lit.lampPlace(3);
  const Rational difference = product(toA, toA) - product(toB, toB);
  return difference == 0 ? "middle" : difference < 0 ? "A" : "B";
}

void addPoint(Recomputed &expected, const LitTriangle &lit, std::size_t i) {
  const std::string role(1, "ABCM"[i]);
  expected.names[role] = quantity(lit.at.at(i));
  if (lit.sinks != 0) {
    expected.values["t_" + role] = number(lit.sunSteps(i));
    expected.values["S_" + role] = numbers(lit.sunPlace(i));
    expected.names["t_" + role] = quantity(lit.sunSteps(i));
    expected.names["S(" + role + ")"] = quantity(lit.sunPlace(i));
  }
  if (!lit.isLevel(i)) {
    expected.values["k_" + role] = number(lit.lampSteps(i));
    expected.values["L_" + role] = numbers(lit.lampPlace(i));
    expected.names["k_" + role] = quantity(lit.lampSteps(i));
    expected.names["L(" + role + ")"] = quantity(lit.lampPlace(i));
  }
  if (i == 3)
    return;
  if (lit.isSun())
    expected.values["sun_" + role] = lit.sinks == 0 ? "parallel" : lit.isSunny(i) ? "falls" : "plane-first";
  if (lit.isPlane())
    expected.values["lamp_" + role] = lampWord(lit, i);
}

Recomputed recompute(Objects objects) {
  const LitTriangle lit(objects);
  Recomputed expected;
  expected.caseName = caseOf(lit);
  expected.degenerate = !lit.isSun();
  expected.names = {{"\\vec n", quantity(lit.E.normal)},
                    {"P_0", quantity(lit.E.point)},
                    {"Q", quantity(lit.Q)},
                    {"\\vec r", quantity(lit.r.vector)}};
  if (!lit.isPlane())
    expected.vanished.insert("E.n");
  expected.values["M"] = numbers(lit.at[3]);
  if (lit.isSun())
    expected.values["denominator"] = number(Rational(-lit.sinks));
  for (std::size_t i = 0; i < lit.at.size(); ++i)
    addPoint(expected, lit, i);
  const bool isSun = isSunny(lit);
  const bool isLamp = isLampLit(lit);
  expected.values["facing"] =
      number(determinant(lit.r.vector, ExactVec3(lit.at[1] - lit.at[0]), ExactVec3(lit.at[2] - lit.at[0])));
  expected.values["ahead_A"] = number(Rational(lit.height[0] - lit.lampHeight));
  if (!lit.isLevel(0))
    expected.values["ratio"] = number(Rational(lit.depth(1) / lit.depth(0)));
  expected.values["sun_shadow"] =
      isSun ? shapeOf(true, lit.sunPlace(0), lit.sunPlace(1), lit.sunPlace(2)) : "none";
  expected.values["lamp_shadow"] =
      isLamp ? shapeOf(true, lit.lampPlace(0), lit.lampPlace(1), lit.lampPlace(2)) : "none";
  expected.values["nearer"] = nearerOf(lit);
  if (lit.hasPart()) {
    const Rational part = lit.depth(1) / (lit.depth(0) + lit.depth(1));
    expected.values["part"] = number(part);
    expected.names["p"] = quantity(part);
  }
  return expected;
}

void addMiddles(std::vector<WrongAnswer> &all, const LitTriangle &lit) {
  const ExactVec3 middle = lit.at[3];
  addVector(all, "M", "the difference halved", ExactVec3(ExactVec3(lit.at[1] - lit.at[0]) / Rational(2)),
            middle);
  addVector(all, "M", "not halved", ExactVec3(lit.at[0] + lit.at[1]), middle);
  if (lit.sinks != 0) {
    const Rational sum = lit.sunSteps(0) + lit.sunSteps(1);
    Line mean("mean", Rational(sum / 2), all);
    mean.add("not halved", sum);
    mean.add("the difference halved", Rational((lit.sunSteps(1) - lit.sunSteps(0)) / 2));
    mean.add("the other difference halved", Rational((lit.sunSteps(0) - lit.sunSteps(1)) / 2));
    const ExactVec3 both = lit.sunPlace(0) + lit.sunPlace(1);
    addVector(all, "sun-middle", "not halved", both, ExactVec3(both / Rational(2)));
    addVector(all, "sun-middle", "the difference halved",
              ExactVec3(ExactVec3(lit.sunPlace(0) - lit.sunPlace(1)) / Rational(2)),
              ExactVec3(both / Rational(2)));
  }
  if (!lit.hasPart())
    return;
  const Rational a = lit.lampSteps(0);
  const Rational b = lit.lampSteps(1);
  Line part("part", Rational(a / (a + b)), all);
  addFraction(part, a, Rational(a + b));
  part.addRatio("from the other end", b, Rational(a + b));
  part.addRatio("one by the other", a, b);
  part.addRatio("subtracted below", a, Rational(a - b));
  addPointOnRay(all, "lamp-middle", lit.lampPlace(0), Rational(a / (a + b)),
                ExactVec3(lit.lampPlace(1) - lit.lampPlace(0)));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const LitTriangle lit(objects);
  std::vector<WrongAnswer> all;
  if (!lit.isSun())
    return all;
  addProduct(all, "along", lit.r.vector, lit.E.normal);
  for (std::size_t i = 0; i < lit.at.size(); ++i) {
    const std::string role(1, "ABCM"[i]);
    const ExactVec3 &point = lit.at.at(i);
    if (lit.sinks != 0) {
      addParameter(all, ("t-" + role).c_str(), lit.E.normal, lit.E.point, {point, lit.r.vector});
      addPointOnRay(all, ("sun-" + role).c_str(), point, lit.sunSteps(i), lit.r.vector);
    }
    if (lit.isLevel(i))
      continue;
    addParameter(all, ("k-" + role).c_str(), lit.E.normal, lit.E.point, {lit.Q, ExactVec3(point - lit.Q)});
    addPointOnRay(all, ("lamp-" + role).c_str(), lit.Q, lit.lampSteps(i), ExactVec3(point - lit.Q));
  }
  addMiddles(all, lit);
  return all;
}

} // namespace

namespace expected {

Expected shadow() { return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.4}; }

} // namespace expected
} // namespace halfspace::test
