#include "lessons/object/kinds/number.h"

#include "lessons/object/kind.h"
#include "lessons/words.h"

#include <algorithm>

namespace halfspace {
namespace {

void settle(Object &object) {
  NumberObject number = objectAs<NumberObject>(object).value();
  number.step = std::max(number.step, Rational(0));
  number.to = std::max(number.from, number.to);
  number.value = std::clamp(number.value, number.from, number.to);
  object = number;
}

} // namespace

namespace object_kinds {

Kind number() {
  return {.word = NumberObject::kind,
          .noun = [] { return words("a number"); },
          .meaning = "a number with bounds and a step",
          .subject = {},
          .coordinates = {{"value", CoordinateRole::Number, true},
                          {"from", CoordinateRole::Number},
                          {"to", CoordinateRole::Number},
                          {"step", CoordinateRole::Number}},
          .leavableVertices = 0,
          .shape = {},
          .binding = {},
          .settle = settle,
          .draw = drawNothing,
          .ownHandles = noHandles,
          .offer = offerNothing,
          .aim = aimAtNothing};
}

} // namespace object_kinds
} // namespace halfspace
