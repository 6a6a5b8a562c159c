#include "lessons/object/kinds/line.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct TwoLines {
  explicit TwoLines(Objects objects)
      : g(objectAs<LineObject>(*objects[0]).value()), h(objectAs<LineObject>(*objects[1]).value()),
        w(h.point - g.point), gg(product(g.direction, g.direction)), gh(product(g.direction, h.direction)),
        hh(product(h.direction, h.direction)), turn(determinant(g.direction, w, h.direction)) {}

  bool areLines() const { return gg != 0 && hh != 0; }
  /// By the equality of Cauchy and Schwarz.
  bool areAlong() const { return areLines() && gh * gh == gg * hh; }
  bool areAcross() const { return areLines() && gh * gh != gg * hh; }
  bool liesOnG(const ExactVec3 &point) const {
    return vanishes(perpendicular(ExactVec3(point - g.point), g.direction));
  }
  bool liesOnH(const ExactVec3 &point) const {
    return vanishes(perpendicular(ExactVec3(point - h.point), h.direction));
  }
  bool areSame() const { return areAlong() && liesOnG(h.point); }
  bool areParallel() const { return areAlong() && !liesOnG(h.point); }
  bool meet() const { return areAcross() && turn == 0; }
  bool areSkew() const { return areAcross() && turn != 0; }
  /// The first line's point is the nearest one of its line: the way from it to its foot on the other line is
  /// perpendicular to both.
  bool isBackAtStart() const {
    return areLines() && product(w, g.direction) * hh == product(w, h.direction) * gh;
  }

  LineObject g, h;
  ExactVec3 w;
  Rational gg, gh, hh;
  Rational turn; ///< of both directions and the way between the points
};

bool areLines(const TwoLines &at) { return at.areLines(); }
bool areAlong(const TwoLines &at) { return at.areAlong(); }
bool areAcross(const TwoLines &at) { return at.areAcross(); }
bool areSame(const TwoLines &at) { return at.areSame(); }
bool areParallel(const TwoLines &at) { return at.areParallel(); }
bool meet(const TwoLines &at) { return at.meet(); }
bool areSkew(const TwoLines &at) { return at.areSkew(); }

Claims caseClaims() {
  return claimsAbout<TwoLines>({
      {"{g.v} and {h.v} are zero vectors: they point nowhere, so there are no lines.",
       [](const TwoLines &at) { return at.gg == 0 && at.hh == 0; }},
      {"{g.v} is the zero vector: it points nowhere, so {g} is no line.",
       [](const TwoLines &at) { return at.gg == 0 && at.hh != 0; }},
      {"{h.v} is the zero vector: it points nowhere, so {h} is no line.",
       [](const TwoLines &at) { return at.gg != 0 && at.hh == 0; }},
      {"{g} and {h} are the same line: every point of it lies on both.", areSame},
      {"{g} and {h} are parallel: every point of one is equally far from the other, and no single pair is "
       "closest. {dist}.",
       areParallel},
      {"{g} and {h} meet: both closest points are the common point.", meet},
      {"{g} and {h} neither meet nor are parallel. {F} and {G} are closest: {dist}.", areSkew},
  });
}

Claims wayClaims() {
  return claimsAbout<TwoLines>({
      {"{g.A} is its own foot: it lies on {h}, too.",
       [](const TwoLines &at) { return at.areLines() && at.liesOnH(at.g.point); }},
      {"The foot of {g.A} on {h}.",
       [](const TwoLines &at) { return at.areLines() && !at.liesOnH(at.g.point); }},
      {"The foot of H on {g} is {g.A} again.", [](const TwoLines &at) { return at.isBackAtStart(); }},
      {"The foot of H on {g}: it is not {g.A}.",
       [](const TwoLines &at) { return at.areLines() && !at.isBackAtStart(); }},
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

Claims closest_points() { return together({caseClaims(), wayClaims(), boxClaims()}); }

} // namespace claims
} // namespace halfspace::test
