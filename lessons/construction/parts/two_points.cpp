#include "lessons/construction/parts/two_points.h"

#include "lessons/construction/parts/worked_lines.h"

namespace halfspace {

WorkingLine wayLine(const WayBetweenPoints &at) {
  return asked(withNumbers(at.w == at.B - at.A),
               at.areApart ? words("From {A} to {B}.", at.letters)
                           : words("The zero vector: {A} and {B} are the same point.", at.letters));
}

} // namespace halfspace
