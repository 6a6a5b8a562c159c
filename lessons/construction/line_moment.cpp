#include "lessons/construction/line_moment.h"

#include "lessons/object/drawing.h"

namespace halfspace {
namespace {

/// In units of the picture.
constexpr double drawnMomentLength = 3;

} // namespace

Symbol besideLettersOf(const Given<LineObject> &line, Symbol letter) {
  letter.owner = line.letters.back().owner;
  return letter;
}

Term momentOf(const Given<LineObject> &line) {
  const auto &[point, direction] = line.object;
  const LineTerms g = termsOf(line);
  return name(besideLettersOf(line, vectorLetter("m")), ExactVec3(cross(point, direction)))
      .standingFor(cross(g.A, g.v));
}

ArrowMark momentArrow(const Term &moment) {
  ArrowMark arrow = arrowOf(moment, Place(0), Role::Derived, Subject::Measure);
  arrow.drawnLength = drawnMomentLength;
  return arrow;
}

} // namespace halfspace
