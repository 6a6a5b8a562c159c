#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/ray.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

#include <algorithm>

namespace halfspace::test {
namespace {

/// What the ray's points put into a plane's equation come to: slope·t + rest = 0.
struct Equation {
  Rational slope;
  Rational rest;

  bool isSolved() const { return slope != 0; }
  Rational t() const { return -rest / slope; }
  bool isHit() const { return isSolved() && t() >= 0; }
  bool holdsAlways() const { return slope == 0 && rest == 0; }
};

/// Several planes, and the ray behind them.
struct RayAtPlanes {
  explicit RayAtPlanes(Objects objects) {
    const auto L = objectAs<RayObject>(*objects.back()).value();
    isRay = !vanishes(L.direction);
    for (const Object *object : objects.first(objects.size() - 1)) {
      const auto E = objectAs<PlaneObject>(*object).value();
      arePlanes = arePlanes && !vanishes(E.normal);
      equations.push_back({product(E.normal, L.direction), product(E.normal, ExactVec3(L.origin - E.point))});
      if (equations.back().isHit())
        parameters.push_back(equations.back().t());
    }
    std::sort(parameters.begin(), parameters.end());
  }

  bool isSound() const { return arePlanes && isRay; }
  bool liesInAPlane() const {
    return std::any_of(equations.begin(), equations.end(),
                       [](const auto &each) { return each.holdsAlways(); });
  }
  std::size_t hits() const { return isSound() ? parameters.size() : 0; }
  /// How many planes are hit at the smallest parameter.
  long ties() const {
    return hits() == 0 ? 0 : std::count(parameters.begin(), parameters.end(), parameters.front());
  }

  bool isRay = true;
  bool arePlanes = true;
  std::vector<Equation> equations;
  std::vector<Rational> parameters; ///< of the planes that are hit, from the smallest on
};

/// Of the plane whose number a line's id ends with.
const Equation &equationOf(const RayAtPlanes &at, const Said &said) {
  return at.equations.at(std::stoul(said.line.substr(said.line.find_first_of("0123456789"))));
}

/// Of so many planes the letters are put together: “E and F”, “E, F and G”.
std::size_t countNames(const std::string &names) {
  const auto commas = std::count(names.begin(), names.end(), ',');
  return static_cast<std::size_t>(commas) + (names.find(" and ") == std::string::npos ? 1 : 2);
}

bool hitsAPlane(const RayAtPlanes &at) { return at.hits() > 0; }

Claims caseClaims() {
  return claimsAbout<RayAtPlanes>({
      {"The normal {n} is the zero vector: it points nowhere, so {plane} is no plane.",
       [](const RayAtPlanes &at) { return !at.arePlanes; }},
      {"The direction {r} is the zero vector: the ray goes nowhere.",
       [](const RayAtPlanes &at) { return !at.isRay; }},
      {"One plane has a t of 0 or more: the ray hits this one and no other.",
       [](const RayAtPlanes &at) { return at.hits() == 1 && !at.liesInAPlane(); }},
      {"It hits another plane at a single point: one t is 0 or more.",
       [](const RayAtPlanes &at) { return at.hits() == 1 && at.liesInAPlane(); }},
      {"{planes} have the same t ({t}): the ray hits them at one point.",
       [](const RayAtPlanes &at, const Said &said) {
         return at.ties() > 1 && countNames(said.at("planes")) == static_cast<std::size_t>(at.ties());
       }},
      {"More than one plane has a t of 0 or more: the smallest of these tells which is hit first.",
       [](const RayAtPlanes &at) { return at.hits() > 1 && at.ties() == 1; }},
      {"No plane has a t of 0 or more: the ray meets none of them.",
       [](const RayAtPlanes &at) { return at.isSound() && at.hits() == 0 && !at.liesInAPlane(); }},
      {"The whole ray lies in {planes}. It hits no plane at a single point.",
       [](const RayAtPlanes &at, const Said &said) {
         const auto inside = std::count_if(at.equations.begin(), at.equations.end(),
                                           [](const auto &each) { return each.holdsAlways(); });
         return at.isSound() && at.hits() == 0 &&
                countNames(said.at("planes")) == static_cast<std::size_t>(inside);
       }},
      {"The whole ray lies in {planes}. {hit}",
       [](const RayAtPlanes &at) { return at.isSound() && at.liesInAPlane() && at.hits() > 0; }},
      {"{before} and {last}", always},
      {"{before}, {last}", always},
  });
}

Claims lineClaims() {
  return claimsAbout<RayAtPlanes>({
      {"The ray's points: all their coordinates follow from the one number t.",
       [](const RayAtPlanes &at) { return at.isRay; }},
      {"The equation of {plane}, with {d} = −{n}·{P0}.", [](const RayAtPlanes &at) { return at.arePlanes; }},
      {"t drops out, and what is left is wrong for every t: the ray never meets {plane}.",
       [](const RayAtPlanes &at, const Said &said) {
         return at.isSound() && equationOf(at, said).slope == 0 && equationOf(at, said).rest != 0;
       }},
      {"t drops out, and 0 = 0 is true for every t: the whole ray lies in {plane}.",
       [](const RayAtPlanes &at, const Said &said) {
         return at.isSound() && equationOf(at, said).holdsAlways();
       }},
      {"The ray's coordinates put into the equation of {plane}, then collected. One unknown is left: t.",
       [](const RayAtPlanes &at, const Said &said) { return equationOf(at, said).isSolved(); }},
      {"Negative: only the line backwards meets {plane}. It is behind the start.",
       [](const RayAtPlanes &at, const Said &said) {
         return equationOf(at, said).isSolved() && equationOf(at, said).t() < 0;
       }},
      {"Not negative: the ray meets {plane} at this t.",
       [](const RayAtPlanes &at, const Said &said) { return equationOf(at, said).isHit(); }},
      {"In their order. The first t that is 0 or more tells what the ray hits first.", hitsAPlane},
      {"In their order. No t is 0 or more, so the ray hits no plane at a single point.",
       [](const RayAtPlanes &at) { return at.isSound() && at.hits() == 0 && at.liesInAPlane(); }},
      {"In their order. No t is 0 or more, so the ray meets no plane.",
       [](const RayAtPlanes &at) { return at.isSound() && at.hits() == 0 && !at.liesInAPlane(); }},
      {"There is no t for {planes}.",
       [](const RayAtPlanes &at, const Said &said) {
         const auto without = std::count_if(at.equations.begin(), at.equations.end(),
                                            [](const auto &each) { return !each.isSolved(); });
         return at.isSound() && countNames(said.at("planes")) == static_cast<std::size_t>(without);
       }},
      {"The smallest t that is not negative, put into the ray.", hitsAPlane},
  });
}

} // namespace

namespace claims {

Claims ray_plane_substitution() { return together({caseClaims(), lineClaims()}); }

} // namespace claims
} // namespace halfspace::test
