#include "lessons/object/kinds/box.h"
#include "lessons/object/kinds/ray.h"
#include "lessons/term/plain_text.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

#include <algorithm>

namespace halfspace::test {
namespace {

/// The stretch of t in which the ray's line is in a slab: without ends where it never leaves it.
struct Stretch {
  bool isEmpty = false;
  std::optional<Rational> from{};
  std::optional<Rational> to{};
};

struct RayAtBox {
  explicit RayAtBox(Objects objects)
      : K(objectAs<BoxObject>(*objects[0]).value()), L(objectAs<RayObject>(*objects[1]).value()) {
    for (int axis = 0; axis < 3; ++axis)
      cut(axis);
  }

  [[nodiscard]] bool isLine() const { return !vanishes(L.direction); }
  [[nodiscard]] bool isFlat(int axis) const { return K.lowest[axis] == K.highest()[axis]; }
  [[nodiscard]] bool startsIn(int axis) const {
    return !(L.origin[axis] < K.lowest[axis]) && !(K.highest()[axis] < L.origin[axis]);
  }
  [[nodiscard]] bool startsInBox() const { return startsIn(0) && startsIn(1) && startsIn(2); }
  [[nodiscard]] bool isMet() const { return isLine() && !common.isEmpty; }
  [[nodiscard]] bool isMetOnce() const { return isMet() && common.from == common.to; }
  /// Of the line's stretch in the box, whether it begins or ends at t = 0 or later.
  [[nodiscard]] bool beginsAhead() const { return isMet() && *common.from >= 0; }
  [[nodiscard]] bool endsAhead() const { return isMet() && *common.to >= 0; }
  [[nodiscard]] bool isBesideSome() const {
    return isLine() && std::any_of(axes.begin(), axes.end(),
                                   [this](int axis) { return L.direction[axis] == 0 && !startsIn(axis); });
  }
  /// How many faces have a point of the line in their plane, where it goes in or comes out.
  [[nodiscard]] long slabsWith(std::optional<Rational> Stretch::*end) const {
    return std::count_if(axes.begin(), axes.end(), [&](int axis) {
      return L.direction[axis] != 0 && slabs.at(std::size_t(axis)).*end == common.*end;
    });
  }

  static constexpr std::array axes{0, 1, 2};
  BoxObject K;
  RayObject L;
  std::array<Stretch, 3> slabs{};
  Stretch common{}; ///< in all slabs at once

private:
  void cut(int axis) {
    Stretch &slab = slabs.at(std::size_t(axis));
    if (L.direction[axis] == 0) {
      slab.isEmpty = !startsIn(axis);
    } else {
      const ExactVec3 perStep = ExactVec3(1) / ExactVec3(L.direction[axis]);
      const Rational one = (K.lowest[axis] - L.origin[axis]) * perStep.x;
      const Rational other = (K.highest()[axis] - L.origin[axis]) * perStep.x;
      slab.from = one < other ? one : other;
      slab.to = one < other ? other : one;
    }
    if (slab.from && (!common.from || *common.from < *slab.from))
      common.from = slab.from;
    if (slab.to && (!common.to || *slab.to < *common.to))
      common.to = slab.to;
    common.isEmpty = common.isEmpty || slab.isEmpty || (common.from && *common.to < *common.from);
  }
};

/// The axis of which a sentence speaks.
int axisOf(const Said &said) { return said.at("axis").front() - 'x'; }

bool isMet(const RayAtBox &at) { return at.isMet(); }
bool isMissedBySlabs(const RayAtBox &at) { return at.isLine() && at.common.isEmpty && !at.isBesideSome(); }
bool hasSpan(const RayAtBox &at) { return at.isLine() && !at.isBesideSome(); }

/// Whether the plane `x = 2` is one of its slab's.
bool isOfSlab(const RayAtBox &at, const std::string &plane) {
  const std::string axis = plane.substr(0, 1);
  const int index = axis.front() - 'x';
  return plane == axis + relatedText(Term(at.K.lowest[index])) ||
         plane == axis + relatedText(Term(at.K.highest()[index]));
}

Claims caseClaims() {
  return claimsAbout<RayAtBox>({
      {"The direction {r} is the zero vector: the ray goes nowhere.",
       [](const RayAtBox &at) { return !at.isLine(); }},
      {"{in} and {out}: the ray meets the box in only one point, {H1}.",
       [](const RayAtBox &at) { return at.isMetOnce() && at.beginsAhead(); }},
      {"The ray is in the box from {H1} on, with {in}, up to {H2}, with {out}.",
       [](const RayAtBox &at) { return at.beginsAhead() && !at.isMetOnce(); }},
      {"{in} is negative: the ray starts in the box. It leaves the box at {H2}, with {out}.",
       [](const RayAtBox &at) { return at.startsInBox() && !at.beginsAhead() && *at.common.to > 0; }},
      {"{out}: the ray starts on the box and leads away from it. It has only its start in common with the "
       "box.",
       [](const RayAtBox &at) { return at.startsInBox() && at.isMet() && *at.common.to == 0; }},
      {"{out} is negative: the box is behind the ray's start, so the ray does not meet it.",
       [](const RayAtBox &at) { return at.isMet() && !at.endsAhead(); }},
      {"{in} is larger than {out}: the line leaves one slab before it comes into another, so the ray misses "
       "the "
       "box.",
       isMissedBySlabs},
      {"{step} = 0: the ray runs beside the {axis} slab and never comes into it, so it misses the box.",
       [](const RayAtBox &at, const Said &said) {
         return at.isLine() && at.L.direction[axisOf(said)] == 0 && !at.startsIn(axisOf(said));
       }},
  });
}

Claims slabClaims() {
  return claimsAbout<RayAtBox>({
      {"The two planes of the {axis} slab are one: {plane}.",
       [](const RayAtBox &at, const Said &said) { return at.isFlat(axisOf(said)); }},
      {"{step} is positive, so {axis} grows: the plane {plane} comes first.",
       [](const RayAtBox &at, const Said &said) {
         return at.L.direction[axisOf(said)] > 0 && !at.isFlat(axisOf(said)) &&
                isOfSlab(at, said.at("plane"));
       }},
      {"{step} is negative, so {axis} shrinks: the plane {plane} comes first.",
       [](const RayAtBox &at, const Said &said) {
         return at.L.direction[axisOf(said)] < 0 && !at.isFlat(axisOf(said)) &&
                isOfSlab(at, said.at("plane"));
       }},
      {"The line leaves the {axis} slab through the plane {plane}.",
       [](const RayAtBox &at, const Said &said) {
         return at.L.direction[axisOf(said)] != 0 && isOfSlab(at, said.at("plane"));
       }},
      {"The start is in the {axis} slab, and {step} = 0: the ray never leaves this slab.",
       [](const RayAtBox &at, const Said &said) {
         return at.L.direction[axisOf(said)] == 0 && at.startsIn(axisOf(said));
       }},
      {"The start is not in the {axis} slab, and {step} = 0: the ray never comes into this slab.",
       [](const RayAtBox &at, const Said &said) {
         return at.L.direction[axisOf(said)] == 0 && !at.startsIn(axisOf(said));
       }},
      {"The start is in the {axis} slab.",
       [](const RayAtBox &at, const Said &said) { return at.startsIn(axisOf(said)); }},
      {"The start is not in the {axis} slab.",
       [](const RayAtBox &at, const Said &said) { return !at.startsIn(axisOf(said)); }},
  });
}

Claims lineClaims() {
  return claimsAbout<RayAtBox>({
      {"In their order. All ways in stand before all ways out.", isMet},
      {"In their order. A way out stands before a way in.", isMissedBySlabs},
      {"The largest: only then has the line come into every slab.", hasSpan},
      {"The smallest: there the line leaves a slab for the first time.", hasSpan},
      {"There is no other: the line is always in the other two slabs.",
       [](const RayAtBox &at) {
         return hasSpan(at) && std::count_if(RayAtBox::axes.begin(), RayAtBox::axes.end(),
                                             [&](int axis) { return at.L.direction[axis] == 0; }) == 2;
       }},
      {"From the one to the other the line is in the box.",
       [](const RayAtBox &at) { return at.isMet() && !at.isMetOnce(); }},
      {"The line meets the box in only one point.", [](const RayAtBox &at) { return at.isMetOnce(); }},
      {"The line misses the box.", isMissedBySlabs},
      {"Both are negative: the box is behind the start.",
       [](const RayAtBox &at) { return at.isMet() && !at.endsAhead(); }},
      {"Only t_in is negative: the ray starts in the box.",
       [](const RayAtBox &at) { return at.endsAhead() && !at.beginsAhead() && at.startsInBox(); }},
      {"Neither is negative: the ray meets the box.",
       [](const RayAtBox &at) { return at.beginsAhead() && at.endsAhead(); }},
      {"The {axis} slab gave {t}: the point is in the face {plane}.",
       [](const RayAtBox &at, const Said &said) {
         const auto end = said.line.ends_with('1') ? &Stretch::from : &Stretch::to;
         return at.isMet() && at.slabsWith(end) == 1 && isOfSlab(at, said.at("plane"));
       }},
      {"Several slabs gave {t}: the point is on an edge or at a corner.",
       [](const RayAtBox &at, const Said &said) {
         const auto end = said.line.ends_with('1') ? &Stretch::from : &Stretch::to;
         return at.isMet() && at.slabsWith(end) > 1;
       }},
  });
}

} // namespace

namespace claims {

Claims ray_box_slabs() { return together({caseClaims(), slabClaims(), lineClaims()}); }

} // namespace claims
} // namespace halfspace::test
