#include "lessons/construction/parts/line_moment.h"

#include "lessons/object/drawing.h"
#include "lessons/object/letters.h"

namespace halfspace {
namespace {

/// In units of the picture.
constexpr double drawnMomentLength = 3;

} // namespace

Term momentOf(const Given<LineObject> &line) {
  const auto &[point, direction] = line.object;
  const LineTerms g = termsOf(line);
  return name(besideLettersOf(line, vectorLetter("m")), ExactVec3(cross(point, direction)))
      .standingFor(cross(g.A, g.v));
}

ArrowMark momentArrow(const Term &moment, const Look &look) {
  return inLook(look, ArrowMark{drawn(moment, Role::Derived, Subject::Measure), Place(0),
                                unitOf(vectorOf(moment)), false, drawnMomentLength});
}

} // namespace halfspace
