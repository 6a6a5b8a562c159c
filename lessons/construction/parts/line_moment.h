// The moment of a line, as all constructions of Plücker coordinates write and draw it.
#pragma once

#include "lessons/figure/mark.h"
#include "lessons/object/kinds/line.h"

namespace halfspace {

/// A letter that says whose it is where the object's own letters do: m beside v, m with the index g beside v
/// with the index g.
template <class Kind> [[nodiscard]] Symbol besideLettersOf(const Given<Kind> &object, Symbol letter) {
  letter.owner = object.letters.back().owner;
  return letter;
}

/// m = A×v.
[[nodiscard]] Term momentOf(const Given<LineObject> &line);

/// The moment ≠ 0 of a line with a look, as an arrow from the origin. It may be very long: only its direction
/// is drawn.
[[nodiscard]] ArrowMark momentArrow(const Term &moment, const Look &look);

} // namespace halfspace
