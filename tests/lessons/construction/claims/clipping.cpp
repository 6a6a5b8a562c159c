#include "lessons/object/kinds/plane.h"
#include "lessons/object/kinds/point.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct TriangleAtPlane {
  explicit TriangleAtPlane(Objects objects) : E(objectAs<PlaneObject>(*objects[0]).value()) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      at.at(i) = objectAs<PointObject>(*objects[i + 1])->at;
      f.at(i) = product(E.normal, ExactVec3(at.at(i) - E.point));
    }
  }

  bool isPlane() const { return !vanishes(E.normal); }
  bool isTriangle() const {
    return !vanishes(perpendicular(ExactVec3(at[2] - at[1]), ExactVec3(at[0] - at[1])));
  }
  bool isClipped() const { return isPlane() && isTriangle(); }
  template <class Condition> int count(Condition condition) const {
    return static_cast<int>(std::count_if(f.begin(), f.end(), condition));
  }
  int above() const {
    return count([](const Rational &each) { return each > 0; });
  }
  int below() const {
    return count([](const Rational &each) { return each < 0; });
  }
  int inPlane() const { return 3 - above() - below(); }

  static std::size_t indexOf(const std::string &corner) { return std::string("ABC").find(corner); }
  const Rational &fAt(const Said &said, const char *end) const { return f.at(indexOf(said.at(end))); }
  bool hasBothSigns(const Said &said) const { return fAt(said, "from") * fAt(said, "to") < 0; }

  /// The corners of what is left: from each corner on, itself, then the cut of its edge; begun with those
  /// behind the first corner, which comes last.
  std::string kept() const {
    std::string names;
    const auto add = [&](const std::string &name) { names += (names.empty() ? "" : ", ") + name; };
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (f.at(i) * f.at(next) < 0)
        add(std::string("H") + std::array{"₁", "₂", "₃"}.at(i));
      if (f.at(next) >= 0)
        add(std::string(1, "ABC"[next]));
    }
    return names;
  }

  PlaneObject E;
  std::array<ExactVec3, 3> at;
  std::array<Rational, 3> f;
};

using At = TriangleAtPlane;

} // namespace

namespace claims {

Claims clipping() {
  return claimsAbout<At>({
      {"The normal {n} is the zero vector: it points nowhere, so there is no plane.",
       [](const At &at) { return !at.isPlane(); }},
      {"{A}, {B} and {C} lie on one line: there is no triangle to clip.",
       [](const At &at) { return !at.isTriangle(); }},
      {"All three f are 0: the triangle lies in the plane, and all of it is kept.",
       [](const At &at) { return at.isClipped() && at.inPlane() == 3; }},
      {"No f is negative: the whole triangle is kept.",
       [](const At &at) { return at.isClipped() && at.below() == 0; }},
      {"The plane cuts the triangle. What is left is a triangle: {corners}.",
       [](const At &at, const Said &said) {
         return at.isClipped() && at.above() == 1 && at.below() > 0 && said.at("corners") == at.kept();
       }},
      {"The plane cuts the triangle. What is left is a quadrilateral: {corners}.",
       [](const At &at, const Said &said) {
         return at.isClipped() && at.above() == 2 && at.below() == 1 && said.at("corners") == at.kept();
       }},
      {"All three f are negative: nothing of the triangle is kept.",
       [](const At &at) { return at.below() == 3; }},
      {"Only {corners} lies in the plane, and all the rest is cut off: a single point is left.",
       [](const At &at, const Said &said) {
         return at.below() == 2 && at.inPlane() == 1 && at.f.at(At::indexOf(said.at("corners"))) == 0;
       }},
      {"Only the edge between {first} and {last} lies in the plane, and all the rest is cut off: a segment "
       "is left.",
       [](const At &at, const Said &said) {
         return at.below() == 1 && at.fAt(said, "first") == 0 && at.fAt(said, "last") == 0 &&
                said.at("first") != said.at("last");
       }},
      {"This part of the way from {from} to {to} leads to where f is 0.",
       [](const At &at, const Said &said) { return at.hasBothSigns(said); }},
      {"Here the edge from {from} to {to} is cut.",
       [](const At &at, const Said &said) { return at.hasBothSigns(said); }},
      {"0: so {H} lies in the plane.", [](const At &at) { return at.above() > 0 && at.below() > 0; }},
      {"Both {from} and {to} are kept: write down {to}.",
       [](const At &at, const Said &said) { return at.fAt(said, "from") >= 0 && at.fAt(said, "to") >= 0; }},
      {"Neither {from} nor {to} is kept: write down nothing.",
       [](const At &at, const Said &said) { return at.fAt(said, "from") < 0 && at.fAt(said, "to") < 0; }},
      {"{from} is kept and {to} is not: write down the cut {H}.",
       [](const At &at, const Said &said) { return at.fAt(said, "from") > 0 && at.fAt(said, "to") < 0; }},
      {"{from} is kept and {to} is not. The edge leaves the plane at {from} itself: write down nothing.",
       [](const At &at, const Said &said) { return at.fAt(said, "from") == 0 && at.fAt(said, "to") < 0; }},
      {"{from} is not kept and {to} is: write down the cut {H}, then {to}.",
       [](const At &at, const Said &said) { return at.fAt(said, "from") < 0 && at.fAt(said, "to") > 0; }},
      {"{from} is not kept and {to} is. The edge meets the plane at {to} itself: write down only {to}.",
       [](const At &at, const Said &said) { return at.fAt(said, "from") < 0 && at.fAt(said, "to") == 0; }},
      {"The corners of what is left, in the order of the walk.",
       [](const At &at) { return at.isClipped() && at.below() < 3; }},
  });
}

} // namespace claims
} // namespace halfspace::test
