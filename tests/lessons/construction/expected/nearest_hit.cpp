#include "lessons/object/kinds/number.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/expected/torpedo_tools.h"
#include "tests/lessons/construction/expected/wrong_answer_tools.h"

namespace halfspace::test {
namespace {

/// A triangle of one of the meshes.
struct Fragment {
  std::size_t mesh;
  Triangle<Rational> triangle;
};

struct Given {
  RayObject ray;
  Rational i;
  std::vector<Fragment> fragments;
};

Given read(Objects objects) {
  Given given{objectAs<RayObject>(*objects[0]).value(), objectAs<NumberObject>(*objects[1])->value, {}};
  for (std::size_t i = 2; i < objects.size(); ++i)
    for (const Triangle<Rational> &triangle : trianglesOf(objectAs<MeshObject>(*objects[i]).value()))
      given.fragments.push_back({i - 2, triangle});
  return given;
}

/// Parameters of hits with the numbers of their triangles: ascending, those of the same parameter by number.
using Hits = std::set<std::pair<Rational, int>>;

struct AllMet {
  std::vector<Met> each;
  Hits ahead;
  Hits behind;
};

AllMet meetAll(const Given &given) {
  AllMet all;
  for (const Fragment &fragment : given.fragments) {
    all.each.push_back(meet({given.ray.origin, given.ray.direction}, fragment.triangle));
    const auto &[caseName, lambda] = all.each.back();
    const auto number = static_cast<int>(all.each.size());
    if (caseName == "hit")
      all.ahead.emplace(*lambda, number);
    if (caseName == "behind")
      all.behind.emplace(*lambda, number);
  }
  return all;
}

/// The fragment that i chooses; null for none.
const Fragment *chosenOf(const Given &given) {
  for (std::size_t i = 0; i < given.fragments.size(); ++i)
    if (given.i == Rational(static_cast<int>(i) + 1))
      return &given.fragments[i];
  return nullptr;
}

/// Whether a ray in the triangle's plane comes to the triangle: it starts in it, or hits a fence along its
/// border.
bool comesTo(const RayObject &ray, const Triangle<Rational> &triangle) {
  const auto &[a, b, c] = triangle;
  const ExactVec3 up = perpendicular(ExactVec3(b - a), ExactVec3(c - a));
  const auto isHit = [](const RayObject &from, const Triangle<Rational> &target) {
    return meet({from.origin, from.direction}, target).caseName == "hit";
  };
  const auto hitsFence = [&](const ExactVec3 &from, const ExactVec3 &to) {
    return isHit(ray, {from - up, to - up, from + up}) || isHit(ray, {to + up, from + up, to - up});
  };
  return isHit({ray.origin, up}, triangle) || hitsFence(a, b) || hitsFence(b, c) || hitsFence(c, a);
}

bool comesAlong(const Given &given, const AllMet &all) {
  for (std::size_t i = 0; i < all.each.size(); ++i)
    if (all.each[i].caseName == "in-plane" && comesTo(given.ray, given.fragments[i].triangle))
      return true;
  return false;
}

/// Which mesh is hit first, and whether another is at the same parameter.
std::string wordForFirst(const Given &given, const AllMet &all) {
  std::set<std::size_t> meshes;
  for (const auto &[lambda, number] : all.ahead)
    if (lambda == all.ahead.begin()->first)
      meshes.insert(given.fragments[static_cast<std::size_t>(number) - 1].mesh);
  if (meshes.empty())
    return comesAlong(given, all) ? "in-plane" : "none";
  return meshes.size() > 1 ? "several" : "mesh" + std::to_string(*meshes.begin());
}

void addChosen(const Given &given, const AllMet &all, Recomputed &expected) {
  const Fragment *chosen = chosenOf(given);
  if (!chosen)
    return;
  expected.names["P_0"] = quantity(chosen->triangle.p0);
  expected.names["P_1"] = quantity(chosen->triangle.p1);
  expected.names["P_2"] = quantity(chosen->triangle.p2);
  if (expected.degenerate)
    return;
  expected.values["chosen.case"] =
      all.each[static_cast<std::size_t>(chosen - given.fragments.data())].caseName;
  for (const auto &[lambda, number] : all.ahead)
    if (Rational(number) <= given.i) {
      expected.values["so_far"] = number;
      expected.values["so_far_is_nearest"] = number == all.ahead.begin()->second ? "yes" : "no";
      break;
    }
}

/// As LaTeX: an index of several digits stands in braces.
std::string indexed(const std::string &letter, int index) {
  const std::string text = std::to_string(index);
  return letter + "_" + (text.size() > 1 ? "{" + text + "}" : text);
}

/// By how many sides a point of a triangle lies on.
std::string placeOf(const ExactVec3 &point, const Triangle<Rational> &triangle) {
  const auto isOn = [&](const ExactVec3 &from, const ExactVec3 &to) {
    return vanishes(perpendicular(ExactVec3(from - point), ExactVec3(to - point)));
  };
  const int sides = int(isOn(triangle.p0, triangle.p1)) + int(isOn(triangle.p1, triangle.p2)) +
                    int(isOn(triangle.p2, triangle.p0));
  return sides == 0 ? "interior" : sides == 1 ? "edge" : "vertex";
}

void addNearest(const Given &given, const AllMet &all, Recomputed &expected) {
  const auto &[lambda, number] = *all.ahead.begin();
  const ExactVec3 point = given.ray.origin + given.ray.direction * lambda;
  expected.values["nearest"] = number;
  expected.values["ties"] = static_cast<int>(std::count_if(
      all.ahead.begin(), all.ahead.end(), [&first = lambda](const auto &hit) { return hit.first == first; }));
  expected.values["lambda"] = test::number(lambda);
  expected.values["point"] = numbers(point);
  expected.values["location"] =
      placeOf(point, given.fragments[static_cast<std::size_t>(number) - 1].triangle);
  expected.names["H"] = quantity(point);
  expected.names["\\lambda_H"] = quantity(lambda);
}

Recomputed recompute(Objects objects) {
  const Given given = read(objects);
  const AllMet all = meetAll(given);
  Recomputed expected;
  expected.names = {{"Q", quantity(given.ray.origin)}, {"\\vec r", quantity(given.ray.direction)}};
  for (std::size_t i = 2; i < objects.size(); ++i)
    expected.names[objects.size() == 3 ? "P" : "P_{\\operatorname{meshes}_" + std::to_string(i - 2) + "}"] =
        quantity((*objects[i])[0]);
  expected.values["fragments"] = static_cast<int>(given.fragments.size());
  expected.degenerate = vanishes(given.ray.direction);
  expected.caseName = expected.degenerate      ? "zero-direction"
                      : !all.ahead.empty()     ? "hit"
                      : comesAlong(given, all) ? "in-plane"
                                               : "miss";
  addChosen(given, all, expected);
  if (expected.degenerate)
    return expected;
  expected.values["first"] = wordForFirst(given, all);
  expected.values["hits"] = static_cast<int>(all.ahead.size());
  expected.values["behind"] = static_cast<int>(all.behind.size());
  for (const Hits &hits : {all.ahead, all.behind})
    for (const auto &[lambda, number] : hits)
      expected.names[indexed("\\lambda", number)] = quantity(lambda);
  if (!all.ahead.empty())
    addNearest(given, all, expected);
  return expected;
}

std::vector<WrongAnswer> wrongAnswers(Objects objects) {
  const Given given = read(objects);
  std::vector<WrongAnswer> all;
  if (vanishes(given.ray.direction))
    return all;
  if (const Hits hits = meetAll(given).ahead; !hits.empty())
    addPointOnRay(all, "hit", given.ray.origin, hits.begin()->first, given.ray.direction);
  return all;
}

} // namespace

namespace expected {

Expected nearest_hit() {
  return {.recompute = recompute, .wrongAnswers = wrongAnswers, .leastShareNamed = 0.1};
}

} // namespace expected
} // namespace halfspace::test
