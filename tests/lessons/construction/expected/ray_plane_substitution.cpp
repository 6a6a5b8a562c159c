#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/recompute_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

struct Given {
  std::vector<PlaneObject> planes;
  RayObject ray;
};

Given read(Objects objects) {
  Given given;
  for (const Object *object : objects.first(objects.size() - 1))
    given.planes.push_back(objectAs<PlaneObject>(*object).value());
  given.ray = objectAs<RayObject>(*objects.back()).value();
  return given;
}

/// What the plane's left side n·P − n·P0 comes to at a point.
Rational leftSide(const PlaneObject &plane, const ExactVec3 &at) {
  return product(plane.normal, at) - product(plane.normal, plane.point);
}

/// The plane's left side at the ray's start, and one step later: it changes evenly on the way.
struct Sides {
  Rational atStart;
  Rational slope;
};

Sides sidesOf(const PlaneObject &plane, const RayObject &ray) {
  const Rational atStart = leftSide(plane, ray.origin);
  return {atStart, leftSide(plane, ExactVec3(ray.origin + ray.direction)) - atStart};
}

/// How a list's object is written in a formula.
std::string symbolOf(std::size_t place) { return "\\operatorname{planes}_" + std::to_string(place); }

std::string caseOf(const Sides &sides) {
  if (sides.slope == 0)
    return sides.atStart == 0 ? "in-plane" : "parallel";
  const bool comesNearer = (sides.atStart > 0) != (sides.slope > 0);
  return sides.atStart == 0 || comesNearer ? "hit" : "behind";
}

void nameLetters(Recomputed &expected, const Given &given) {
  expected.names = {{"Q", quantity(given.ray.origin)},
                    {"\\vec r", quantity(given.ray.direction)},
                    {"t", quantity(somewhere.x)}};
  expected.unknowns = coordinatesAt(somewhere);
  expected.unknowns["t"] = quantity(somewhere.y);
  if (vanishes(given.ray.direction))
    expected.vanished.insert("L.r");
  for (std::size_t i = 0; i < given.planes.size(); ++i) {
    const auto &[point, normal] = given.planes[i];
    const bool isAlone = given.planes.size() == 1;
    const std::string symbol = symbolOf(i);
    expected.names[isAlone ? "\\vec n" : "\\vec n_{" + symbol + "}"] = quantity(normal);
    expected.names[isAlone ? "P_0" : "P_{0," + symbol + "}"] = quantity(point);
    expected.names["d_{" + symbol + "}"] = quantity(Rational(-product(normal, point)));
    if (vanishes(normal))
      expected.vanished.insert("planes" + std::to_string(i) + ".n");
  }
}

/// What the plane comes to; its parameter where it has one.
std::optional<Rational> addPlane(Recomputed &expected, const Given &given, std::size_t place) {
  const Sides sides = sidesOf(given.planes[place], given.ray);
  const std::string index = std::to_string(place);
  expected.values["plane" + index + ".case"] = caseOf(sides);
  expected.solutions["equation" + index] = coordinatesAt(given.planes[place].point);
  if (sides.slope == 0)
    return {};
  const Rational t = -sides.atStart / sides.slope;
  const ExactVec3 point = given.ray.origin + given.ray.direction * t;
  expected.values["plane" + index + ".t"] = number(t);
  expected.values["plane" + index + ".point"] = numbers(point);
  expected.solutions["substitute" + index] = {{"t", quantity(t)}};
  expected.names["t_{" + symbolOf(place) + "}"] = quantity(t);
  expected.names["H_{" + symbolOf(place) + "}"] = quantity(point);
  return t;
}

Recomputed recompute(Objects objects) {
  const Given given = read(objects);
  Recomputed expected;
  nameLetters(expected, given);
  const bool lacksNormal = std::any_of(given.planes.begin(), given.planes.end(),
                                       [](const PlaneObject &plane) { return vanishes(plane.normal); });
  expected.degenerate = lacksNormal || vanishes(given.ray.direction);
  if (expected.degenerate) {
    expected.caseName = lacksNormal ? "zero-normal" : "zero-direction";
    return expected;
  }
  std::multimap<Rational, std::size_t> ahead;
  for (std::size_t i = 0; i < given.planes.size(); ++i)
    if (const auto t = addPlane(expected, given, i); t && *t >= 0)
      ahead.emplace(*t, i);
  const bool liesInPlane =
      std::any_of(given.planes.begin(), given.planes.end(),
                  [&](const PlaneObject &plane) { return caseOf(sidesOf(plane, given.ray)) == "in-plane"; });
  expected.caseName = !ahead.empty() ? "hit" : liesInPlane ? "in-plane" : "miss";
  if (ahead.empty()) {
    expected.values["first"] = liesInPlane ? "in-plane" : "none";
    return expected;
  }
  const auto &[t, place] = *ahead.begin();
  const ExactVec3 point = given.ray.origin + given.ray.direction * t;
  expected.values["first"] = ahead.count(t) > 1 ? "several" : "plane" + std::to_string(place);
  expected.values["t"] = number(t);
  expected.values["point"] = numbers(point);
  expected.names["H"] = quantity(point);
  return expected;
}

/// Slips in slope·t + rest = 0 and in solving it.
void addSolving(std::vector<WrongAnswer> &all, const std::string &place, const Sides &sides) {
  const auto &[rest, slope] = sides;
  Line parameter("t" + place, Rational(-rest / slope), all);
  addFraction(parameter, Rational(-rest), slope);
  parameter.addRatio("upside down, and the sign lost", slope, rest);
  parameter.add("not divided, and the sign lost", rest);
  Line equation("substitute" + place, rest, all, "(" + toText(slope) + ")t");
  equation.add("the sign of what has no t lost", Rational(-rest));
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Given given = read(objects);
  std::vector<WrongAnswer> all;
  if (recompute(objects).degenerate)
    return all;
  for (std::size_t i = 0; i < given.planes.size(); ++i)
    if (const Sides sides = sidesOf(given.planes[i], given.ray); sides.slope != 0)
      addSolving(all, std::to_string(i), sides);
  return all;
}

} // namespace

namespace expected {

Expected ray_plane_substitution() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.5};
}

} // namespace expected
} // namespace halfspace::test
