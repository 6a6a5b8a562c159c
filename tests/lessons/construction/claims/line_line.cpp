#include "tests/lessons/construction/claims/two_lines.h"

namespace halfspace::test {
namespace {

bool goesCounterclockwise(const TwoLines &at) { return at.areSkew() && at.turn > 0; }
bool goesClockwise(const TwoLines &at) { return at.areSkew() && at.turn < 0; }

Claims caseClaims() {
  return claimsAbout<TwoLines>({
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

Claims line_line() { return together({zeroLinesClaims(), caseClaims(), lineClaims()}); }

} // namespace claims
} // namespace halfspace::test
