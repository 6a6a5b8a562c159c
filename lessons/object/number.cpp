// Numbers, to be changed within bounds in steps.
#include "lessons/object/kind.h"

#include <algorithm>

namespace halfspace {
namespace {

enum Coordinates : std::uint8_t { Value, From, To, Step };

void settle(Object &number) {
  number[Step].x = std::max(number[Step].x, Rational(0));
  number[To].x = std::max(number[From].x, number[To].x);
  number[Value].x = std::clamp(number[Value].x, number[From].x, number[To].x);
}

/// A number is no part of the picture.
std::vector<Mark> draw(const Given<Object> &) { return {}; }

} // namespace

namespace object_kinds {

Kind number() {
  return {.word = "number",
          .meaning = "a number with bounds and a step",
          .coordinates = {{"value", CoordinateRole::Number, true},
                          {"from", CoordinateRole::Number},
                          {"to", CoordinateRole::Number},
                          {"step", CoordinateRole::Number}},
          .leavableVertices = 0,
          .settle = settle,
          .draw = draw,
          .ownHandles = noHandles,
          .offer = offerNothing,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
