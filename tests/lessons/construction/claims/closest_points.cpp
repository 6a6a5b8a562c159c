#include "tests/lessons/construction/claims/two_lines.h"

namespace halfspace::test {
namespace {

struct ClosestPoints : TwoLines {
  using TwoLines::TwoLines;

  bool liesOnH(const ExactVec3 &point) const {
    return vanishes(perpendicular(ExactVec3(point - h.point), h.direction));
  }
  /// The first line's point is the nearest one of its line: the way from it to its foot on the other line is
  /// perpendicular to both.
  bool isBackAtStart() const {
    return areLines() && product(way, g.direction) * product(h.direction, h.direction) ==
                             product(way, h.direction) * product(g.direction, h.direction);
  }
};

Claims caseClaims() {
  return claimsAbout<TwoLines>({
      {"{g} and {h} are the same line: every point of it lies on both.", areSame},
      {"{g} and {h} are parallel: every point of one is equally far from the other, and no single pair is "
       "closest. {dist}.",
       areParallel},
      {"{g} and {h} meet: both closest points are the common point.", meet},
      {"{g} and {h} neither meet nor are parallel. {F} and {G} are closest: {dist}.", areSkew},
  });
}

Claims wayClaims() {
  return claimsAbout<ClosestPoints>({
      {"{g.A} is its own foot: it lies on {h}, too.",
       [](const ClosestPoints &at) { return at.areLines() && at.liesOnH(at.g.point); }},
      {"The foot of {g.A} on {h}.",
       [](const ClosestPoints &at) { return at.areLines() && !at.liesOnH(at.g.point); }},
      {"The foot of H on {g} is {g.A} again.", [](const ClosestPoints &at) { return at.isBackAtStart(); }},
      {"The foot of H on {g}: it is not {g.A}.",
       [](const ClosestPoints &at) { return at.areLines() && !at.isBackAtStart(); }},
      {"From {g.A} to {h.A}.", always},
      {"The connection is perpendicular to {g}.", areLines},
      {"The connection is perpendicular to {h}.", areLines},
      {"Not 0: the directions are no multiples of each other, so exactly one s and one t fit.", areAcross},
      {"0: the directions are multiples of each other, so more than one s and t fit.", areAlong},
      {"So many steps {g.v} lead from {g.A} to {F}.", areAcross},
      {"So many steps {h.v} lead from {h.A} to {G}.", areAcross},
      {"The closest point of {g}.", areAcross},
      {"The closest point of {h}.", areAcross},
      {"0: both are the common point of the lines.", meet},
      {"The length of the arrow from {F} to {G}.", areSkew},
  });
}

Claims boxClaims() {
  return claimsAbout<TwoLines>({
      {"Perpendicular to both lines.", areAcross},
      {"The zero vector: the directions are multiples of each other.", areAlong},
      {"Parallel lines: how far {h.A} is from {g}, an area over the length of its base.", areParallel},
      {"0: {h.A} lies on {g}, as every point of the same line does.", areSame},
      {"0: the lines meet.", meet},
      {"How far w reaches along n, without a sign: the distance of the lines.", areSkew},
      {"0: the directions are multiples of each other, so the box has no base.", areAlong},
      {"0: w lies in the plane of both lines, so the box has no height.", meet},
      {"The volume of the box of {g.v}, {h.v} and w.", areSkew},
      {"The area of its base, the parallelogram of {g.v} and {h.v}.", areAcross},
      {"0: {g.v} and {h.v} span no parallelogram.", areAlong},
      {"The volume over the area of the base is the height, and that is the distance.", areAcross},
  });
}

} // namespace

namespace claims {

Claims closest_points() { return together({zeroLinesClaims(), caseClaims(), wayClaims(), boxClaims()}); }

} // namespace claims
} // namespace halfspace::test
