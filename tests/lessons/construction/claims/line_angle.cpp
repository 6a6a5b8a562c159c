#include "tests/lessons/construction/claims/said_angle.h"
#include "tests/lessons/construction/claims/two_lines.h"

namespace halfspace::test {
namespace {

Rational productOf(const TwoLines &at) { return product(at.g.direction, at.h.direction); }

/// Whether the angle is told that is at most 90°, as far as it is written.
bool isAngleOfLines(const TwoLines &at, const Said &said) {
  const ExactVec3 second = productOf(at) < 0 ? ExactVec3(-at.h.direction) : at.h.direction;
  return at.areLines() && isAngleBetween(at.g.direction, second, said.at("degrees"));
}

} // namespace

namespace claims {

Claims line_angle() {
  const Claims own = claimsAbout<TwoLines>({
      {"{g} and {h} are the same line: the angle is 0°.", areSame},
      {"{g} and {h} are parallel: the angle is 0°.", areParallel},
      {"{g.v}·{h.v} = 0: {g} and {h} are perpendicular to each other.",
       [](const TwoLines &at) { return at.areLines() && productOf(at) == 0; }},
      {"The lines {g} and {h} meet at the angle φ{degrees}°.",
       [](const TwoLines &at, const Said &said) {
         return at.meet() && productOf(at) != 0 && isAngleOfLines(at, said);
       }},
      {"The lines {g} and {h} do not meet. Their directions have the angle φ{degrees}°.",
       [](const TwoLines &at, const Said &said) {
         return at.areSkew() && productOf(at) != 0 && isAngleOfLines(at, said);
       }},
      {"Positive: the directions are less than 90° apart.",
       [](const TwoLines &at) { return productOf(at) > 0; }},
      {"Negative: the directions are more than 90° apart. The angle of the lines is at most 90°, so the sign "
       "will be left out.",
       [](const TwoLines &at) { return productOf(at) < 0; }},
      {"Zero: the directions are perpendicular to each other, and so are the lines.",
       [](const TwoLines &at) { return at.areLines() && productOf(at) == 0; }},
      {"The length of {vector}.", areLines},
      {"φ{degrees}°: the angle of the lines. The directions are 180° − φ apart.",
       [](const TwoLines &at, const Said &said) { return productOf(at) < 0 && isAngleOfLines(at, said); }},
      {"φ{degrees}°: the angle of the lines, and of their directions.",
       [](const TwoLines &at, const Said &said) { return productOf(at) >= 0 && isAngleOfLines(at, said); }},
  });
  return together({zeroLinesClaims(), own});
}

} // namespace claims
} // namespace halfspace::test
