#include "lessons/object/kinds/line.h"
#include "tests/lessons/construction/claims/claims.h"
#include "tests/lessons/construction/expected/recompute_tools.h"

namespace halfspace::test {
namespace {

struct TwoLines {
  explicit TwoLines(Objects objects)
      : g(objectAs<LineObject>(*objects[0]).value()), h(objectAs<LineObject>(*objects[1]).value()),
        common(perpendicular(g.direction, h.direction)), way(h.point - g.point),
        turn(determinant(g.direction, way, h.direction)) {}

  bool areLines() const { return !vanishes(g.direction) && !vanishes(h.direction); }
  bool areAlong() const { return areLines() && vanishes(common); }
  bool areSame() const { return areAlong() && vanishes(perpendicular(way, g.direction)); }
  bool areParallel() const { return areAlong() && !areSame(); }
  /// The directions are no multiples of each other.
  bool areAcross() const { return areLines() && !vanishes(common); }
  bool meet() const { return areAcross() && turn == 0; }
  bool areSkew() const { return areAcross() && turn != 0; }

  LineObject g, h;
  ExactVec3 common;
  ExactVec3 way;
  /// How the second line turns around the first, seen with the first one's direction pointing at you: the
  /// way to it and its direction turn as the hands of a clock do where this is negative.
  Rational turn;
};

bool areLines(const TwoLines &at) { return at.areLines(); }
bool areAlong(const TwoLines &at) { return at.areAlong(); }
bool areAcross(const TwoLines &at) { return at.areAcross(); }
bool areSame(const TwoLines &at) { return at.areSame(); }
bool areParallel(const TwoLines &at) { return at.areParallel(); }
bool meet(const TwoLines &at) { return at.meet(); }
bool areSkew(const TwoLines &at) { return at.areSkew(); }
bool goesCounterclockwise(const TwoLines &at) { return at.areSkew() && at.turn > 0; }
bool goesClockwise(const TwoLines &at) { return at.areSkew() && at.turn < 0; }

Claims caseClaims() {
  return claimsAbout<TwoLines>({
      {"{g.v} and {h.v} are zero vectors: they point nowhere, so there are no lines.",
       [](const TwoLines &at) { return vanishes(at.g.direction) && vanishes(at.h.direction); }},
      {"{g.v} is the zero vector: it points nowhere, so {g} is no line.",
       [](const TwoLines &at) { return vanishes(at.g.direction) && !vanishes(at.h.direction); }},
      {"{h.v} is the zero vector: it points nowhere, so {h} is no line.",
       [](const TwoLines &at) { return !vanishes(at.g.direction) && vanishes(at.h.direction); }},
      {"{g} and {h} are the same line, with directions that agree.",
       [](const TwoLines &at) { return at.areSame() && product(at.g.direction, at.h.direction) > 0; }},
      {"{g} and {h} are the same line, with opposite directions.",
       [](const TwoLines &at) { return at.areSame() && product(at.g.direction, at.h.direction) < 0; }},
      {"The directions are multiples of each other, and no point lies on both lines: {g} and {h} are "
       "parallel.",
       areParallel},
      {"The directions differ, and one point lies on both lines: {g} and {h} meet.", meet},
      {"No plane contains both lines: {g} and {h} are skew, they pass each other.", areSkew},
  });
}

Claims lineClaims() {
  return claimsAbout<TwoLines>({
      {"The moment of {g}, the same for every point of it.", areLines},
      {"The moment of {h}.", areLines},
      {"The direction of each line with the moment of the other.", always},
      {"Positive: seen with {g.v} pointing at you, {h} passes {g} counterclockwise.", goesCounterclockwise},
      {"Negative: seen with {g.v} pointing at you, {h} passes {g} clockwise.", goesClockwise},
      {"Zero, and the directions are no multiples of each other: the lines meet.", meet},
      {"Zero: the directions are multiples of each other, so neither line passes the other.", areAlong},
      {"The volume of the tetrahedron with the two arrows as opposite edges.", areSkew},
      {"0: the ends of the two arrows lie in one plane.",
       [](const TwoLines &at) { return at.meet() || at.areAlong(); }},
      {"Zero: the directions are perpendicular. The lines need not meet for that.",
       [](const TwoLines &at) { return at.areLines() && product(at.g.direction, at.h.direction) == 0; }},
      {"The lines are perpendicular when this is 0.",
       [](const TwoLines &at) { return product(at.g.direction, at.h.direction) != 0; }},
      {"Perpendicular to both lines: the shortest way between them runs along it.", areSkew},
      {"Perpendicular to both lines, and so to the plane in which they meet.", meet},
      {"The zero vector: the directions are multiples of each other.", areAlong},
      {"How far {h.A} is from {g}: with parallel lines every point is equally far.", areParallel},
      {"Zero: {h.A} lies on {g}, as every point of the same line does.", areSame},
      {"The distance of the lines: a length, so without the sign of the product.", areSkew},
      {"Zero: the lines meet.", meet},
      {"It takes this many steps {g.v} along {g} to get where the lines come nearest.", areAcross},
      {"It takes this many steps {h.v} to get there along {h}.", areAcross},
      {"The point of {g} that is nearest to {h}.", areAcross},
      {"The point of {h} that is nearest to {g}.", areAcross},
  });
}

} // namespace

namespace claims {

Claims line_line() { return together({caseClaims(), lineClaims()}); }

} // namespace claims
} // namespace halfspace::test
