#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct FourPoints {
  explicit FourPoints(Objects objects) : E(objectAs<PlaneObject>(*objects[0]).value()) {
    for (std::size_t i = 0; i < f.size(); ++i)
      f.at(i) = product(E.normal, ExactVec3(objectAs<PointObject>(*objects[i + 1])->at - E.point));
  }

  bool isPlane() const { return !vanishes(E.normal); }

  /// The points on a side, as a sentence lists them.
  template <class Condition> std::string namesWhere(Condition condition) const {
    std::string names;
    for (std::size_t i = 0; i < f.size(); ++i)
      if (condition(f.at(i)))
        names += (names.empty() ? "" : ", ") + std::string(1, "ABCD"[i]);
    return names;
  }
  std::string positive() const {
    return namesWhere([](const Rational &each) { return each > 0; });
  }
  std::string negative() const {
    return namesWhere([](const Rational &each) { return each < 0; });
  }
  std::string zero() const {
    return namesWhere([](const Rational &each) { return each == 0; });
  }

  PlaneObject E;
  std::array<Rational, 4> f;
};

} // namespace

namespace claims {

Claims half_spaces() {
  return claimsAbout<FourPoints>({
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const FourPoints &at) { return !at.isPlane(); }},
      {"On the side that {n} points to: {points}.",
       [](const FourPoints &at, const Said &said) { return said.at("points") == at.positive(); }},
      {"On the side that {n} points away from: {points}.",
       [](const FourPoints &at, const Said &said) { return said.at("points") == at.negative(); }},
      {"On the other side: {points}.",
       [](const FourPoints &at, const Said &said) {
         return said.at("points") == at.negative() && !at.positive().empty();
       }},
      {"In the plane, on neither side: {points}.",
       [](const FourPoints &at, const Said &said) { return at.isPlane() && said.at("points") == at.zero(); }},
      {"With −{n} for {n} the number is −f({point}): it only changes its sign.",
       [](const FourPoints &at) { return at.f[0] != 0; }},
      {"With −{n} for {n} the number is −f({point}): that is 0 again.",
       [](const FourPoints &at) { return at.f[0] == 0; }},
  });
}

} // namespace claims
} // namespace halfspace::test
