// Points that slide on a line.
#include "lessons/object/bound_point.h"
#include "lessons/object/kinds/line.h"
#include "lessons/words.h"

namespace halfspace::object_kinds {

Kind point_on_line() {
  return boundPoint(
      "point-on-line", [] { return words("a point on a line"); }, "a point that slides on a line: A + λv",
      {{"lambda", CoordinateRole::Number}}, settleNothing, bindingByLambda(LineObject::kind));
}

} // namespace halfspace::object_kinds
